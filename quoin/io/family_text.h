// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/arrangement/circular/circular_family.h"
#include "quoin/arrangement/geodesic/geodesic_family.h"
#include "quoin/arrangement/linear/linear_family.h"
#include "quoin/io/exact_lines.h"

namespace quoin::io {

/// How supports, points and branches of a family are written as words, and read.
///
/// Writing: `support_words`, `point_words` and `branch_word`; `numbers` are those that supports have in the text, and
/// `supports_of` tells which ones the definition of a point names. Reading, from the present line: `read_support`
/// (which gets the number that follows), `read_point` and `read_branch`; InputErrors are of the family or of the lines.
/// `ends_on` gives the copies of the points of two vertices that are the ends of an edge on a branch; `lies_on` tells,
/// exactly, whether such an end lies on the branch.
template <class F>
struct FamilyText;

using SupportNumbers = std::vector<std::uint32_t>;
inline constexpr std::uint32_t no_support = 0xFFFFFFFFU;

template <>
struct FamilyText<LinearFamily> {
  using F = LinearFamily;
  static constexpr std::string_view name = "linear";

  static std::uint32_t support(BranchId b) { return b.value; }
  static std::array<std::uint32_t, 2> supports_of(const F::Point& p);
  static std::string support_words(const F& family, std::uint32_t support);
  static std::string point_words(const F& family, const F::Point& p, const SupportNumbers& numbers);
  static std::string branch_word(const F& family, BranchId b, const SupportNumbers& numbers);

  static void read_support(F& family, const ExactLines& lines);
  static F::Point read_point(F& family, const ExactLines& lines);
  static BranchId read_branch(const F& family, std::string_view word, const ExactLines& lines);
  static std::array<F::Point, 2> ends_on(F&, BranchId, const F::Point& left, const F::Point& right) {
    return {left, right};
  }
  static bool lies_on(F& family, const F::Point& p, BranchId b);
};

template <>
struct FamilyText<CircularFamily> {
  using F = CircularFamily;
  static constexpr std::string_view name = "circular";

  static std::uint32_t support(BranchId b) { return b.value / 2; }
  static std::array<std::uint32_t, 2> supports_of(const F::Point& p);
  static std::string support_words(const F& family, std::uint32_t support);
  static std::string point_words(const F& family, const F::Point& p, const SupportNumbers& numbers);
  static std::string branch_word(const F& family, BranchId b, const SupportNumbers& numbers);

  static void read_support(F& family, const ExactLines& lines);
  static F::Point read_point(F& family, const ExactLines& lines);
  static BranchId read_branch(const F& family, std::string_view word, const ExactLines& lines);
  static std::array<F::Point, 2> ends_on(F&, BranchId, const F::Point& left, const F::Point& right) {
    return {left, right};
  }
  static bool lies_on(F& family, const F::Point& p, BranchId b);
};

template <>
struct FamilyText<GeodesicFamily> {
  using F = GeodesicFamily;
  static constexpr std::string_view name = "geodesic";

  static std::uint32_t support(BranchId b) { return F::support(b); }
  static std::array<std::uint32_t, 2> supports_of(const F::Point& p);
  static std::string support_words(const F& family, std::uint32_t support);
  static std::string point_words(const F& family, const F::Point& p, const SupportNumbers& numbers);
  static std::string branch_word(const F& family, BranchId b, const SupportNumbers& numbers);

  static void read_support(F& family, const ExactLines& lines);
  static F::Point read_point(F& family, const ExactLines& lines);
  static BranchId read_branch(const F& family, std::string_view word, const ExactLines& lines);
  /// A pole end of its own at a pole; the right copy of a right end on the identification.
  static std::array<F::Point, 2> ends_on(F& family, BranchId b, const F::Point& left, const F::Point& right);
  static bool lies_on(F& family, const F::Point& p, BranchId b);
};

/// Whether a point is at a pole.
template <class Point>
bool is_at_pole(const Point&) {
  return false;
}
inline bool is_at_pole(const GeodesicFamily::Point& p) {
  return p.side == Side::bottom || p.side == Side::top;
}

/// Rough order of vertices, where a point may be a lone pole, whatever longitude it has: that is met with u = -pi,
/// below or above all others there.
template <class Point>
int rank_of(const Point&, bool /*is_lone*/) {
  return 0;
}
inline int rank_of(const GeodesicFamily::Point& p, bool is_lone) {
  if (is_lone && is_at_pole(p)) return p.side == Side::bottom ? 0 : 2;
  return p.column < 0 ? 1 : 3;
}

}  // namespace quoin::io
