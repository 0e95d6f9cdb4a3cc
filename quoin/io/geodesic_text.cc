// SPDX-License-Identifier: Apache-2.0
#include "quoin/base/error.h"
#include "quoin/io/family_text.h"

namespace quoin::io {

using Text = FamilyText<GeodesicFamily>;

namespace {

std::string words_of(const std::array<Integer, 3>& v) {
  return v[0].to_string() + " " + v[1].to_string() + " " + v[2].to_string();
}

SphereDirection read_direction(const ExactLines& lines) {
  const auto& words = lines.words();
  if (words.size() < 4) lines.fail("the line is too short");
  lines.expect_size(4);
  return std::array<Integer, 3>{Integer::parse(words[1]), Integer::parse(words[2]), Integer::parse(words[3])};
}

/// The normal of the support as the family has it, whatever its branches.
std::array<Integer, 3> own_normal(const GeodesicFamily& family, std::uint32_t support) {
  return family.normal(GeodesicFamily::branch(support, true));
}

}  // namespace

std::array<std::uint32_t, 2> Text::supports_of(const GeodesicFamily::Point& p) {
  if (p.is_crossing() && !is_at_pole(p)) return {p.first, p.second};
  return {no_support, no_support};
}

std::string Text::support_words(const GeodesicFamily& family, std::uint32_t support) {
  return "circle " + words_of(own_normal(family, support));
}

std::string Text::point_words(const GeodesicFamily& family, const GeodesicFamily::Point& p,
                              const SupportNumbers& numbers) {
  if (!p.is_crossing() || is_at_pole(p)) return "direction " + words_of(family.direction(p));
  return "crossing " + std::to_string(numbers[p.first]) + " " + std::to_string(numbers[p.second]) +
         (p.sign > 0 ? " +" : " -");
}

std::string Text::branch_word(const GeodesicFamily& family, BranchId b, const SupportNumbers& numbers) {
  const std::string number = std::to_string(numbers[support(b)]);
  if (!family.is_vertical(b)) return number;
  return number + (GeodesicFamily::is_second_half(b) ? ":second" : ":first");
}

void Text::read_support(GeodesicFamily& family, const ExactLines& lines) {
  if (lines.words()[0] != "circle") lines.fail("'circle' should stand here");
  const std::size_t before = family.support_count();
  if (family.add_circle(read_direction(lines)) < before) lines.fail("this circle was given before");
}

GeodesicFamily::Point Text::read_point(GeodesicFamily& family, const ExactLines& lines) {
  const auto& words = lines.words();
  if (words[0] == "direction") return family.make_point(read_direction(lines));
  if (words[0] != "crossing") lines.fail(quoted(words[0]) + " is no point of a geodesic arrangement");
  if (words.size() < 4) lines.fail("the line is too short");
  lines.expect_size(4);
  const std::uint32_t a = lines.index(1, family.support_count());
  const std::uint32_t b = lines.index(2, family.support_count());
  if (words[3] != "+" && words[3] != "-") lines.fail(quoted(words[3]) + " is neither '+' nor '-'");
  return family.make_crossing(a, b, words[3] == "+" ? 1 : -1);
}

BranchId Text::read_branch(const GeodesicFamily& family, std::string_view word, const ExactLines& lines) {
  const std::size_t colon = word.find(':');
  const std::uint32_t support = lines.index(word.substr(0, colon), family.support_count());
  const bool is_vertical = family.is_vertical(GeodesicFamily::branch(support, false));
  if (is_vertical == (colon == std::string_view::npos)) {
    lines.fail(is_vertical ? "a circle through the poles needs ':first' or ':second'" : "this circle has no halves");
  }
  if (!is_vertical) return GeodesicFamily::branch(support, false);
  const std::string_view half = word.substr(colon + 1);
  if (half != "first" && half != "second") lines.fail(quoted(half) + " is neither 'first' nor 'second'");
  return GeodesicFamily::branch(support, half == "second");
}

std::array<GeodesicFamily::Point, 2> Text::ends_on(GeodesicFamily& family, BranchId b,
                                                   const GeodesicFamily::Point& left,
                                                   const GeodesicFamily::Point& right) {
  std::array<GeodesicFamily::Point, 2> ends{left, right};
  if (!family.is_vertical(b)) {
    ends[1] = GeodesicFamily::right_copy(right);
    return ends;
  }
  for (GeodesicFamily::Point& end : ends) {
    if (is_at_pole(end)) end = family.make_pole_end(b, end.side);
  }
  return ends;
}

/// Of a vertical branch, the horizontal direction is e_z times its normal.
bool Text::lies_on(GeodesicFamily& family, const GeodesicFamily::Point& p, BranchId b) {
  if (is_at_pole(p)) return family.is_vertical(b);
  if (!family.is_vertical(b)) return family.compare_y_at_x(p, b) == Sign::zero;
  const std::array<Integer, 3> n = family.normal(b);
  const std::array<Integer, 3> d = family.direction(p);
  return (n[0] * d[0] + n[1] * d[1]).sign() == Sign::zero && (n[0] * d[1] - n[1] * d[0]).sign() == Sign::positive;
}

}  // namespace quoin::io
