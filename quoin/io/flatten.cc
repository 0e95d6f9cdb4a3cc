// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "quoin/base/error.h"
#include "quoin/io/drawing_formats.h"
#include "quoin/number/error_free.h"

namespace quoin::io {

namespace {

constexpr double max_chords = 1e6;

// A chord that turns through t is r (1 - cos(t/2)) = 2 r sin(t/4)^2 from its arc.
double chord_count(double half_chord, double bulge, double tolerance) {
  const double radius = half_chord / 2 * (1 / bulge + bulge);
  const double turn = 4 * std::atan(bulge);
  const double ratio = std::sqrt(tolerance / 2 / radius);
  const double largest = ratio < 0.5 ? 4 * std::asin(ratio) : 2.0;
  return std::ceil(turn / largest * (1 + 1e-9));
}

void append_arc(DrawingPath& chain, const Point2& a, const Point2& b, double bulge, double tolerance,
                const std::string& element) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double size = std::fabs(bulge);
  const double chords = chord_count(std::hypot(dx / 2, dy / 2), size, tolerance);
  if (!(chords <= max_chords)) throw InputError(element + ": an arc needs more than a million chords");
  const double half_turn = 2 * std::atan(size);
  const double sine = 2 / (1 / size + size);  // of half_turn
  for (double k = 1; k < chords; ++k) {
    // From a: a chord of part t of the turn, which leads off the whole chord by half of the rest.
    const double t = k / chords;
    const double scale = std::sin(t * half_turn) / sine;
    const double off = (bulge > 0 ? -1 : 1) * (1 - t) * half_turn;
    const double c = scale * std::cos(off);
    const double s = scale * std::sin(off);
    const Point2 p{a.x + (c * dx - s * dy), a.y + (s * dx + c * dy)};
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      throw InputError(element + ": an arc leads beyond the largest double");
    chain.points.push_back(p);
  }
}

}  // namespace

DrawingPath flattened(const DrawingPath& path, double tolerance, const std::string& element) {
  DrawingPath chain;
  chain.is_closed = path.is_closed;
  for (std::size_t e = 0; e < path.edge_count(); ++e) {
    chain.points.push_back(path.start(e));
    if (path.bulge(e) != 0 && path.start(e) != path.end(e))
      append_arc(chain, path.start(e), path.end(e), path.bulge(e), tolerance, element);
  }
  if (!path.is_closed) chain.points.push_back(path.points.back());
  return chain;
}

DrawingPath circle_path(const DrawingCircle& circle, DrawingNotes& notes, const std::string& element) {
  if (!(circle.radius > 0)) throw InputError(element + ": the radius is not positive");
  const TwoDoubles left = two_difference(circle.center.x, circle.radius);
  const TwoDoubles right = two_sum(circle.center.x, circle.radius);
  if (!std::isfinite(left.value) || !std::isfinite(right.value))
    throw InputError(element + ": the circle leads beyond the largest double");
  // Each end moves the centre by half as much and the radius by half as much.
  const double moved = std::fabs(left.tail) + std::fabs(right.tail);
  if (moved > 0) notes.moved("circles are rounded", element, moved);
  return {{{left.value, circle.center.y}, {right.value, circle.center.y}}, {1, 1}, true};
}

void note_open_end(const DrawingPath& path, const std::string& element, DrawingNotes& notes) {
  if (!path.is_closed && path.points.size() > 2 && path.points.front() == path.points.back())
    notes.count("open paths that end where they begin read back as closed", element);
  if (path.is_closed && path.points.size() == 1) notes.count("closed paths of one vertex read back as open", element);
}

}  // namespace quoin::io
