// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "quoin/base/error.h"
#include "quoin/io/family_text.h"

namespace quoin::io {

using Text = FamilyText<CircularFamily>;

namespace {

// What stands for root -1, 0 and 1.
constexpr std::array<std::string_view, 3> roots{"first", "only", "second"};

CircularSupportId support_id(std::uint32_t support) {
  return CircularSupportId(std::size_t{support});
}

std::string words_of(const Rational& x, const Rational& y) {
  return exact_word(x) + " " + exact_word(y);
}

/// Far beyond doubles is beyond what the family takes, and must not get as far.
ExactNumber number_in_range(std::string_view word) {
  ExactNumber number = parse_exact(word);
  if (!number.value && !std::isfinite(number.exact.to_double())) {
    throw InputError(quoted(word) + " is beyond all doubles");
  }
  return number;
}

CircularPoint read_crossing(const CircularFamily& family, const ExactLines& lines) {
  const auto& words = lines.words();
  if (words.size() < 4) lines.fail("the line is too short");
  lines.expect_size(4);
  const CircularSupportId a = support_id(lines.index(1, family.support_count()));
  const CircularSupportId b = support_id(lines.index(2, family.support_count()));
  if (family.same_branch(CircularFamily::lower_half(a), CircularFamily::lower_half(b))) {
    throw InputError("these supports are the same");
  }
  CircularPoint points[2];
  const int count = family.crossings(a, b, points);
  for (int i = 0; i < count; ++i) {
    if (words[3] == roots[static_cast<std::size_t>(points[i].root + 1)]) return points[i];
  }
  lines.fail("these supports have no crossing " + quoted(words[3]));
}

}  // namespace

std::array<std::uint32_t, 2> Text::supports_of(const CircularPoint& p) {
  if (p.kind == CircularPointKind::crossing) return {p.first, p.second};
  return {p.kind == CircularPointKind::extreme ? p.first : no_support, no_support};
}

std::string Text::support_words(const CircularFamily& family, std::uint32_t support) {
  const CircularSupportId id = support_id(support);
  if (family.is_line(id)) {
    const RationalLine line = family.line(id);
    return "line " + words_of(line.x, line.y) + " " + words_of(line.end_x, line.end_y);
  }
  const RationalCircle circle = family.circle(id);
  const CircularSupport& rounded = family.rounded(id);
  return "circle " + words_of(circle.x, circle.y) +
         (rounded.form == CircularForm::radius ? " radius " + exact_word(rounded.radius)
                                               : " squared " + exact_word(circle.squared_radius));
}

std::string Text::point_words(const CircularFamily& family, const CircularPoint& p, const SupportNumbers& numbers) {
  switch (p.kind) {
    case CircularPointKind::doubles:
      return "point " + exact_word(p.x) + " " + exact_word(p.y);
    case CircularPointKind::rational: {
      const RationalPoint2 exact = family.pools().exact_point(p.rational);
      return "point " + words_of(exact.x, exact.y);
    }
    case CircularPointKind::extreme:
      return (p.root < 0 ? "leftmost " : "rightmost ") + std::to_string(numbers[p.first]);
    case CircularPointKind::crossing:
      break;
  }
  return "crossing " + std::to_string(numbers[p.first]) + " " + std::to_string(numbers[p.second]) + " " +
         std::string(roots[static_cast<std::size_t>(p.root + 1)]);
}

std::string Text::branch_word(const CircularFamily& family, BranchId b, const SupportNumbers& numbers) {
  const std::string number = std::to_string(numbers[support(b)]);
  if (family.is_line(b)) return number;
  return number + (CircularFamily::is_upper(b) ? ":upper" : ":lower");
}

void Text::read_support(CircularFamily& family, const ExactLines& lines) {
  const auto& words = lines.words();
  if (words[0] != "line" && words[0] != "circle") lines.fail("'line' or 'circle' should stand here");
  if (words.size() < 5) lines.fail("the line is too short");
  lines.expect_size(5);
  const ExactNumber x = number_in_range(words[1]);
  const ExactNumber y = number_in_range(words[2]);
  const ExactNumber last = number_in_range(words[4]);
  if (words[0] == "line") {
    const ExactNumber end_x = number_in_range(words[3]);
    if (x.value && y.value && end_x.value && last.value) {
      family.add_line_support(Point2{*x.value, *y.value}, Point2{*end_x.value, *last.value});
    } else {
      family.add_line_support(RationalPoint2{x.rational(), y.rational()},
                              RationalPoint2{end_x.rational(), last.rational()});
    }
    return;
  }
  const bool is_squared = words[3] == "squared";
  if (!is_squared && words[3] != "radius") lines.fail(quoted(words[3]) + " is neither 'radius' nor 'squared'");
  if (!is_squared && x.value && y.value && last.value) {
    family.add_circle_support(Point2{*x.value, *y.value}, *last.value);
    return;
  }
  const Rational square = last.rational();
  if (!is_squared && square.sign() != Sign::positive) throw InputError("the radius is not positive");
  family.add_circle_support(RationalCircle{x.rational(), y.rational(), is_squared ? square : square * square});
}

CircularPoint Text::read_point(CircularFamily& family, const ExactLines& lines) {
  const auto& words = lines.words();
  if (words[0] == "crossing") return read_crossing(family, lines);
  const bool is_right = words[0] == "rightmost";
  if (is_right || words[0] == "leftmost") {
    const CircularSupportId circle = support_id(lines.index(1, family.support_count()));
    lines.expect_size(2);
    if (family.is_line(circle)) throw InputError("this support is no circle");
    return family.extreme(circle, is_right);
  }
  if (words[0] != "point") lines.fail(quoted(words[0]) + " is no point of a circular arrangement");
  if (words.size() < 3) lines.fail("the line is too short");
  lines.expect_size(3);
  const ExactNumber x = number_in_range(words[1]);
  const ExactNumber y = number_in_range(words[2]);
  return x.value && y.value ? family.point(Point2{*x.value, *y.value})
                            : family.point(RationalPoint2{x.rational(), y.rational()});
}

BranchId Text::read_branch(const CircularFamily& family, std::string_view word, const ExactLines& lines) {
  const std::size_t colon = word.find(':');
  const CircularSupportId id = support_id(lines.index(word.substr(0, colon), family.support_count()));
  const std::string_view half = colon == std::string_view::npos ? std::string_view() : word.substr(colon + 1);
  if (family.is_line(id) != (colon == std::string_view::npos)) {
    lines.fail(family.is_line(id) ? "a line has no halves" : "a circle needs ':lower' or ':upper'");
  }
  if (family.is_line(id)) return CircularFamily::line_branch(id);
  if (half != "lower" && half != "upper") lines.fail(quoted(half) + " is neither 'lower' nor 'upper'");
  return half == "upper" ? CircularFamily::upper_half(id) : CircularFamily::lower_half(id);
}

bool Text::lies_on(CircularFamily& family, const CircularPoint& p, BranchId b) {
  CircularPoint copy = p;
  return family.put_on(copy, CircularFamily::support(b)) && family.compare_y_at_x(copy, b) == Sign::zero;
}

}  // namespace quoin::io
