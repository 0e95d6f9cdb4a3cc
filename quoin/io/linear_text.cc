// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "quoin/base/error.h"
#include "quoin/io/family_text.h"

namespace quoin::io {

using Text = FamilyText<LinearFamily>;

namespace {

std::string words_of(const RationalPoint2& p) {
  return exact_word(p.x) + " " + exact_word(p.y);
}

}  // namespace

std::array<std::uint32_t, 2> Text::supports_of(const LinearPoint& p) {
  if (p.is_crossing()) return {p.first, p.second};
  return {p.is_end() ? p.first : no_support, no_support};
}

std::string Text::support_words(const LinearFamily& family, std::uint32_t support) {
  const BranchId line(std::size_t{support});
  return "line " + words_of(family.first_support_point(line)) + " " + words_of(family.second_support_point(line));
}

std::string Text::point_words(const LinearFamily& family, const LinearPoint& p, const SupportNumbers& numbers) {
  if (p.is_explicit()) return "point " + exact_word(p.x) + " " + exact_word(p.y);
  if (p.is_crossing()) {
    return "crossing " + std::to_string(numbers[p.first]) + " " + std::to_string(numbers[p.second]);
  }
  if (p.is_end()) {
    const bool is_first = family.side(p) == Side::left || family.side(p) == Side::bottom;
    return (is_first ? "first " : "last ") + std::to_string(numbers[p.first]);
  }
  return "point " + words_of(family.exact(p));
}

std::string Text::branch_word(const LinearFamily&, BranchId b, const SupportNumbers& numbers) {
  return std::to_string(numbers[b.index()]);
}

void Text::read_support(LinearFamily& family, const ExactLines& lines) {
  const auto& words = lines.words();
  if (words[0] != "line") lines.fail("'line' should stand here");
  if (words.size() < 5) lines.fail("the line is too short");
  lines.expect_size(5);
  std::array<ExactNumber, 4> n;
  for (std::size_t i = 0; i < 4; ++i) n[i] = parse_exact(words[i + 1]);
  if (n[0].value && n[1].value && n[2].value && n[3].value) {
    family.add_line(Point2{*n[0].value, *n[1].value}, Point2{*n[2].value, *n[3].value});
  } else {
    family.add_line(RationalPoint2{n[0].rational(), n[1].rational()}, RationalPoint2{n[2].rational(), n[3].rational()});
  }
}

LinearPoint Text::read_point(LinearFamily& family, const ExactLines& lines) {
  const auto& words = lines.words();
  const std::size_t supports = family.support_count();
  const bool is_first = words[0] == "first";
  if (is_first || words[0] == "last") {
    const BranchId line(std::size_t{lines.index(1, supports)});
    lines.expect_size(2);
    return is_first ? family.first_end(line) : family.last_end(line);
  }
  if (words.size() < 3) lines.fail("the line is too short");
  lines.expect_size(3);
  if (words[0] == "crossing") {
    const BranchId a(std::size_t{lines.index(1, supports)});
    const BranchId b(std::size_t{lines.index(2, supports)});
    if (family.compare_slopes(a, b) == Sign::zero) throw InputError("these lines are parallel");
    // The definition stays what it is, where the family would know simpler coordinates as well.
    LinearPoint p = family.crossing(a, b);
    p.first = std::min(a.value, b.value);
    p.second = std::max(a.value, b.value);
    return p;
  }
  if (words[0] != "point") lines.fail(quoted(words[0]) + " is no point of a linear arrangement");
  const ExactNumber x = parse_exact(words[1]);
  const ExactNumber y = parse_exact(words[2]);
  return x.value && y.value ? LinearFamily::point(Point2{*x.value, *y.value})
                            : family.point(RationalPoint2{x.rational(), y.rational()});
}

BranchId Text::read_branch(const LinearFamily& family, std::string_view word, const ExactLines& lines) {
  return BranchId(std::size_t{lines.index(word, family.support_count())});
}

bool Text::lies_on(LinearFamily& family, const LinearPoint& p, BranchId b) {
  if (p.is_end()) return family.same_branch(BranchId(std::size_t{p.first}), b);
  return family.compare_y_at_x(p, b) == Sign::zero;
}

}  // namespace quoin::io
