// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/inputs.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>
#include <iterator>

#include "quoin/base/error.h"
#include "quoin/cli/diagnosis.h"
#include "quoin/cli/streams.h"
#include "quoin/io/exact_text.h"
#include "quoin/io/text_lines.h"

namespace quoin::cli {

namespace {

bool begins_like_exact_text(std::string_view bytes) {
  return io::first_word(bytes, '#').starts_with("quoin-solid");
}

// The first bytes of a file; none of a pipe, which could not be read again.
std::string first_bytes(const std::string& name) {
  constexpr std::size_t enough = 4096;
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error)) return {};
  std::ifstream file(name, std::ios::binary);
  std::string bytes(enough, '\0');
  file.read(bytes.data(), enough);
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

bool is_pipe(const std::string& name) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(name, error);
  return std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status) ||
         std::filesystem::is_socket(status);
}

ReadOptions read_options(const Options& options) {
  ReadOptions read;
  read.weld_tolerance = options.weld_tolerance;
  return read;
}

std::string text_of(double number) {
  return nlohmann::json(number).dump();
}

Mesh accept(MeshFile file, const std::string& name, const Options& options, std::vector<std::string>& warnings) {
  for (const std::string& w : file.report.warnings) warnings.push_back(shown(name) + ": " + w);
  if (options.weld_tolerance) {
    warnings.push_back(shown(name) + ": " + std::to_string(file.report.welded) + " of " +
                       std::to_string(file.report.vertices_in_file) +
                       " vertices welded to others; the largest move of a coordinate is " +
                       text_of(file.report.weld_displacement));
  }
  return std::move(file.mesh);
}

// The leaf, with the findings as warnings. @throws InputError with the findings where there is none
std::shared_ptr<const Leaf> accept(const std::string& name, const Input& input, const LeafResult& result,
                                   std::vector<std::string>& warnings) {
  const std::vector<std::string> findings = describe(input, result.diagnosis);
  if (!result.leaf) throw InputError(refusal(name, "does not bound a solid", findings));
  for (const std::string& line : findings) warnings.push_back(shown(name) + ": " + line);
  if (result.leaf->tiles.empty()) warnings.push_back(shown(name) + ": " + no_faces);
  return result.leaf;
}

bool is_unbounded(const Input& input) {
  const Brep* exact = std::get_if<Brep>(&input);
  return exact != nullptr && exact->is_unbounded;
}

}  // namespace

Input input_of_bytes(const std::string& bytes, const std::string& name, const Options& options,
                     std::vector<std::string>& warnings, const Context& context) {
  if (ending_of(name) == ".qsolid" || begins_like_exact_text(bytes)) {
    if (options.weld_tolerance) warnings.push_back(shown(name) + ": exact text is not welded");
    return read_exact_text(bytes, shown(name));
  }
  return accept(read_mesh(bytes, shown(name), read_options(options), context), name, options, warnings);
}

Input read_input(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                 const Context& context) {
  if (name == standard_stream || is_pipe(name) || ending_of(name) == ".qsolid" ||
      begins_like_exact_text(first_bytes(name))) {
    return input_of_bytes(read_all(name), name, options, warnings, context);
  }
  return accept(read_mesh(std::filesystem::path(name), read_options(options), context), name, options, warnings);
}

LeafResult make_leaf(const Input& input, const std::string& name, const Context& context) {
  if (const Mesh* mesh = std::get_if<Mesh>(&input)) return quoin::make_leaf(*mesh, {}, context);
  return quoin::make_leaf(std::get<Brep>(input), std::filesystem::path(shown(name)).stem().string(), {}, context);
}

Solid solid_of_leaf(const Input& input, std::shared_ptr<const Leaf> leaf, const Context& context) {
  if (!is_unbounded(input)) return Solid::from_leaf(std::move(leaf), context);
  const Solid operand = Solid::of_complement(std::move(leaf));
  return Solid::evaluate(Expression::leaf(0), {&operand, 1}, context);
}

Solid solid_of_input(const Input& input, const std::string& name, std::vector<std::string>& warnings,
                     const Context& context) {
  return solid_of_leaf(input, accept(name, input, make_leaf(input, name, context), warnings), context);
}

std::vector<std::string> describe(const Input& input, const MeshDiagnosis& diagnosis) {
  return std::holds_alternative<Mesh>(input) ? describe(diagnosis) : describe_boundary(diagnosis);
}

std::string refusal(const std::string& name, const std::string& verdict, const std::vector<std::string>& findings) {
  std::string message = shown(name) + ": " + verdict;
  for (const std::string& line : findings) message += "\n  " + line;
  return message;
}

Solid load_operand(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                   const Context& context) {
  const Input input = read_input(name, options, warnings, context);
  std::shared_ptr<const Leaf> leaf = accept(name, input, make_leaf(input, name, context), warnings);
  return is_unbounded(input) ? Solid::of_complement(std::move(leaf)) : Solid::of_leaf(std::move(leaf));
}

std::vector<Solid> load_operands(const std::vector<std::string>& names, const Options& options,
                                 std::vector<std::string>& warnings, const Context& context) {
  std::vector<Solid> solids;
  for (const std::string& name : names) {
    context.progress("operands", static_cast<double>(solids.size()) / static_cast<double>(names.size()));
    solids.push_back(load_operand(name, options, warnings, context));
  }
  return solids;
}

std::shared_ptr<const Brep> load_boundary(const std::string& name, const Options& options,
                                          std::vector<std::string>& warnings, const Context& context) {
  Input input = read_input(name, options, warnings, context);
  std::shared_ptr<const Leaf> leaf = accept(name, input, make_leaf(input, name, context), warnings);
  if (Brep* exact = std::get_if<Brep>(&input)) return std::make_shared<const Brep>(std::move(*exact));
  input = Mesh{};  // the leaf holds what is needed
  return Solid::from_leaf(std::move(leaf), context).shared_boundary();
}

std::string in_small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string ending_of(const std::string& name) {
  return in_small_letters(std::filesystem::path(name).extension().string());
}

void print_warnings(const std::vector<std::string>& warnings, const Options& options) {
  if (options.quiet) return;
  for (const std::string& w : warnings) note_stream() << "quoin: warning: " << printable(w) << "\n";
}

}  // namespace quoin::cli
