// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/simplex_text.h"

#include <algorithm>
#include <charconv>
#include <span>

#include "quoin/base/error.h"
#include "quoin/io/exact_numbers.h"
#include "quoin/io/text_lines.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

namespace {

constexpr std::uint32_t largest_vertex = 0xFFFFFFFEU;

std::uint32_t vertex_of(const io::TextLines& lines, std::string_view word) {
  std::uint32_t vertex = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), vertex);
  if (error != std::errc() || end != word.data() + word.size() || vertex > largest_vertex)
    lines.fail(io::quoted(word) + " is not the number of a vertex, from 0 to 4294967294");
  return vertex;
}

void add_simplex(const io::TextLines& lines, std::span<const std::string_view> words, SimplexList& list,
                 std::vector<std::uint32_t>& row) {
  if (words.empty()) lines.fail("a simplex needs a vertex");
  if (words.size() > SimplicialComplex::most_vertices) {
    lines.fail("a simplex of " + std::to_string(words.size()) + " vertices; more than " +
               std::to_string(SimplicialComplex::most_vertices) + " have too many faces");
  }
  row.clear();
  for (const std::string_view word : words) {
    row.push_back(vertex_of(lines, word));
    if (std::find(row.begin(), row.end() - 1, row.back()) != row.end() - 1)
      lines.fail("vertex " + std::to_string(row.back()) + " stands here twice");
  }
  list.add(row);
}

io::ExactNumber value_of(const io::TextLines& lines, std::string_view word) {
  try {
    return io::parse_exact(word);
  } catch (const InputError& error) {
    lines.fail(error.what());
  }
}

void require_simplices(const SimplexList& list, const std::string& name) {
  if (list.size() == 0) throw InputError(name + ": there is no simplex");
}

}  // namespace

SimplexList read_simplices(std::string_view text, const std::string& name, const Context& context) {
  io::TextLines lines(text, name, '#');
  SimplexList list;
  std::vector<std::uint32_t> row;
  while (lines.next()) {
    if (list.size() % 1024 == 0) context.poll();
    add_simplex(lines, lines.words(), list, row);
  }
  require_simplices(list, name);
  return list;
}

FiltrationText read_filtration(std::string_view text, const std::string& name, const Context& context) {
  io::TextLines lines(text, name, '#');
  FiltrationText result;
  ExactNumbers values;
  std::vector<std::uint32_t> row;
  while (lines.next()) {
    if (result.simplices.size() % 1024 == 0) context.poll();
    values.add(value_of(lines, lines.words()[0]));
    add_simplex(lines, std::span(lines.words()).subspan(1), result.simplices, row);
  }
  require_simplices(result.simplices, name);
  Grades<Rational> grades = values.grades();
  result.grades = std::move(grades.grade);
  result.values = std::move(grades.values);
  return result;
}

bool begins_like_simplices(std::string_view text) {
  const std::string_view word = io::first_word(text, '#');
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace quoin
