// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstdint>

#include "quoin/arrangement/arrangement.h"

namespace quoin {

/// The cell of an arrangement that contains a point, or that a vertical ray meets. Never a fictitious one.
class Location {
 public:
  enum class Kind : std::uint8_t { vertex, edge, face };

  constexpr Location() = default;
  constexpr Location(dcel::VertexId v) : kind_(Kind::vertex), index_(v.value) {}  // NOLINT(google-explicit-constructor)
  constexpr Location(dcel::EdgeId e) : kind_(Kind::edge), index_(e.value) {}      // NOLINT(google-explicit-constructor)
  constexpr Location(dcel::FaceId f) : index_(f.value) {}                         // NOLINT(google-explicit-constructor)

  constexpr Kind kind() const { return kind_; }
  constexpr bool is_vertex() const { return kind_ == Kind::vertex; }
  constexpr bool is_edge() const { return kind_ == Kind::edge; }
  constexpr bool is_face() const { return kind_ == Kind::face; }
  /// Of the kind that it is; others are none.
  constexpr dcel::VertexId vertex() const { return is_vertex() ? dcel::VertexId(index()) : dcel::VertexId(); }
  constexpr dcel::EdgeId edge() const { return is_edge() ? dcel::EdgeId(index()) : dcel::EdgeId(); }
  constexpr dcel::FaceId face() const { return is_face() ? dcel::FaceId(index()) : dcel::FaceId(); }
  constexpr std::size_t index() const { return index_; }

  friend constexpr bool operator==(Location, Location) = default;
  friend constexpr auto operator<=>(Location, Location) = default;

 private:
  Kind kind_ = Kind::face;
  std::uint32_t index_ = 0xFFFFFFFFU;
};

/// Which way a vertical ray goes.
enum class Direction : std::uint8_t { down, up };

/// Finds the cell that contains a point. `locate` of a constant locator may be called from several threads. The point
/// belongs to the arrangement's family and lies on the surface, not at infinity; on a sphere any copy of it will do.
///
/// A locator refers to its arrangement, which must outlive it. After a change of the arrangement it is stale until
/// `rebuild`: it then answers by exhaustive scans, so that answers are right at any time.
template <class L>
concept PointLocator = requires(L& locator, const L& constant, const typename L::Point& p, Direction d,
                                const Context& context) {
  { constant.locate(p) } -> std::same_as<Location>;
  { constant.is_stale() } -> std::same_as<bool>;
  locator.mark_stale();
  locator.rebuild(context);
};

/// A locator that shoots vertical rays too: the first vertex, or edge that is not vertical, on the open half line above
/// or below a point; if there is none, the face at that end of the ray.
///
/// What contains the starting point is not met: from a point on an edge the ray starts beyond it. A ray that runs along
/// a vertical edge meets its ends only. A ray through an end of an edge meets the vertex.
template <class L>
concept RayShooter = PointLocator<L> && requires(const L& constant, const typename L::Point& p, Direction d) {
  { constant.shoot(p, d) } -> std::same_as<Location>;
};

/// A family that orders points by their first parameter only, as vertical rays need.
template <class F>
concept VerticalFamily = CurveFamily<F> && requires(const F& f, const typename F::Point& p) {
  { f.compare_x(p, p) } -> std::same_as<Sign>;
};

}  // namespace quoin
