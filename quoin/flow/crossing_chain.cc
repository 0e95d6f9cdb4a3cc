// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/crossing_chain.h"

#include <algorithm>
#include <cmath>

#include "quoin/flow/facet_formulas.h"
#include "quoin/number/interval.h"

namespace quoin {

namespace {

using flow::RoundedPlace;
using flow::RoundedRay;
using flow::Vector;

/// 1 if the second triangle has the corners of the first in the same cyclic order, -1 in the other; 0 if it has others.
int same_corners(const FlowTriangle& a, const FlowTriangle& b) {
  for (unsigned i = 0; i < 3; ++i) {
    if (a[0] != b[i]) continue;
    if (a[1] == b[(i + 1) % 3] && a[2] == b[(i + 2) % 3]) return 1;
    if (a[2] == b[(i + 1) % 3] && a[1] == b[(i + 2) % 3]) return -1;
  }
  return 0;
}

/// Of numerator and denominator.
std::array<std::size_t, 2> bits(const Rational& value) {
  return {mpz_sizeinbase(mpq_numref(value.raw()), 2), mpz_sizeinbase(mpq_denref(value.raw()), 2)};
}

}  // namespace

CrossingChain::CrossingChain(std::span<const Point3> points) : points_(points) {
  double largest = 0;
  for (const Point3& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  scale_ = std::ldexp(1.0, std::clamp(-exponent, -900, 900));
}

void CrossingChain::clear() {
  nodes_.clear();
  if (!exact_.empty()) exact_.clear();
}

std::uint32_t CrossingChain::add(Node node) {
  if (node.parent != none) {
    node.depth = nodes_[node.parent].depth + 1;
    most_depth_ = std::max<std::size_t>(most_depth_, node.depth);
  }
  nodes_.push_back(node);
  return size() - 1;
}

std::uint32_t CrossingChain::add_centre(const FlowTriangle& triangle) {
  return add({.triangle = triangle, .state = State::rounded, .place = {}});
}

std::uint32_t CrossingChain::add_centre(const FlowTriangle& triangle, std::uint32_t apex) {
  return add({.triangle = triangle, .apex = apex, .place = {}});
}

std::uint32_t CrossingChain::add_landing(std::uint32_t from, const FlowTriangle& entry, std::uint32_t q) {
  return add({.triangle = {entry[0], entry[1], q}, .parent = from, .apex = entry[2], .place = {}});
}

std::uint32_t CrossingChain::add_landing(std::uint32_t from, const FlowTriangle& entry, std::uint32_t q,
                                         const RoundedPlace& place) {
  return add(
      {.triangle = {entry[0], entry[1], q}, .parent = from, .apex = entry[2], .state = State::rounded, .place = place});
}

bool CrossingChain::convert(const Node& node, const FlowTriangle& entry, RoundedPlace& place) const {
  const int same = same_corners(node.triangle, entry);
  if (node.state != State::rounded) return false;
  const bool is_zero = node.place.t == 0 && node.place.error == 0;
  if (same == 0 && !is_zero) return false;
  place = {same < 0 ? -node.place.t : node.place.t, node.place.error};
  return true;
}

void CrossingChain::round_one(Node& node) {
  node.state = State::vague;
  if (node.parent == none) {
    const auto p = corners(node.triangle);
    if (flow::place_of_centre(*p[0], *p[1], *p[2], points_[node.apex], scale_, node.place)) node.state = State::rounded;
    return;
  }
  const FlowTriangle entry{node.triangle[0], node.triangle[1], node.apex};
  RoundedPlace place;
  if (!convert(nodes_[node.parent], entry, place)) return;
  const auto p = corners(entry);
  const RoundedRay ray(*p[0], *p[1], *p[2], scale_, place);
  if (ray.is_usable() && ray.land(ray.line(points_[node.triangle[2]]), node.place)) node.state = State::rounded;
}

// From the last known point on, without recursion: chains are as long as orbits.
void CrossingChain::round(std::uint32_t node) {
  std::vector<std::uint32_t> open;
  for (std::uint32_t at = node; at != none && nodes_[at].state == State::unknown; at = nodes_[at].parent) {
    open.push_back(at);
  }
  for (; !open.empty(); open.pop_back()) round_one(nodes_[open.back()]);
}

RoundedRay CrossingChain::ray(std::uint32_t node, const FlowTriangle& entry) {
  if (nodes_[node].state == State::unknown) round(node);
  RoundedPlace place{0, HUGE_VAL};
  convert(nodes_[node], entry, place);
  const auto p = corners(entry);
  return {*p[0], *p[1], *p[2], scale_, place};
}

Sign CrossingChain::side(std::uint32_t node) {
  if (nodes_[node].state == State::unknown) round(node);
  const Node& at = nodes_[node];
  if (at.state == State::rounded) {
    if (at.place.t > at.place.error) return Sign::positive;
    if (at.place.t < -at.place.error) return Sign::negative;
  }
  return exact(node).sign();
}

Sign CrossingChain::compare(std::uint32_t node, std::uint32_t other) {
  for (const std::uint32_t at : {node, other}) {
    if (nodes_[at].state == State::unknown) round(at);
  }
  const FlowTriangle triangle = nodes_[node].triangle;
  RoundedPlace here;
  RoundedPlace there;
  if (convert(nodes_[node], triangle, here) && convert(nodes_[other], triangle, there)) {
    const double off = here.t - there.t;
    const double bound = 1.01 * (here.error + there.error) + 4e-16 * std::fabs(off);
    if (off > bound) return Sign::positive;
    if (off < -bound) return Sign::negative;
  }
  return (exact_place(node, triangle) - exact_place(other, triangle)).sign();
}

Rational CrossingChain::landing(const Node& node) {
  const auto p = corners(node.triangle);
  if (node.parent == none) {
    if (node.apex == none) return {};
    return flow::place_of_cell<Rational>({*p[0], *p[1], *p[2]}, points_[node.apex]);
  }
  const FlowTriangle entry{node.triangle[0], node.triangle[1], node.apex};
  const flow::LineFromMidpoint<Rational> from(*p[0], *p[1], points_[node.apex]);
  const flow::FacetLine<Rational> line(*p[0], *p[1], *p[2]);
  const Vector<Rational> normal = cross(flow::between<Rational>(*p[0], *p[1]), flow::between<Rational>(*p[0], *p[2]));
  return flow::landing(line, normal, from.at(exact_place(node.parent, entry)));
}

const Rational& CrossingChain::exact(std::uint32_t node) {
  std::vector<std::uint32_t> open;
  for (std::uint32_t at = node; at != none && !exact_.contains(at); at = nodes_[at].parent) open.push_back(at);
  for (; !open.empty(); open.pop_back()) {
    const std::uint32_t at = open.back();
    Node& here = nodes_[at];
    Rational value = landing(here);
    ++exact_count_;
    const std::array<std::size_t, 2> sizes = bits(value);
    most_bits_ = std::max({most_bits_, sizes[0], sizes[1]});
    exact_bytes_.add((sizes[0] + 7) / 8 + (sizes[1] + 7) / 8);
    // In the scale of the doubles, one over a length.
    const Interval around = Interval::around(value);
    const double unscaled = 1 / scale_;
    here.place.t = (around.lower() + (around.upper() - around.lower()) / 2) * unscaled;
    here.place.error = (around.upper() - around.lower()) * unscaled;
    here.state = std::isfinite(here.place.t) && here.place.error < 1e100 ? State::rounded : State::vague;
    if (std::fabs(here.place.t) < 0x1p-500 && value.sign() != Sign::zero) here.state = State::vague;
    exact_.emplace(at, std::move(value));
  }
  return exact_.at(node);
}

Rational CrossingChain::exact_place(std::uint32_t node, const FlowTriangle& triangle) {
  const FlowTriangle& own = nodes_[node].triangle;
  const int same = same_corners(own, triangle);
  if (same != 0) return same > 0 ? exact(node) : -exact(node);
  const auto normal = [this](const FlowTriangle& t) {
    const auto p = corners(t);
    return cross(flow::between<Rational>(*p[0], *p[1]), flow::between<Rational>(*p[0], *p[2]));
  };
  const Vector<Rational> to = normal(triangle);
  return exact(node) * (dot(normal(own), to) / dot(to, to));
}

RationalPoint3 CrossingChain::exact_point(std::uint32_t node) {
  const auto p = corners(nodes_[node].triangle);
  const flow::Circle<Rational> circle({*p[0], *p[1], *p[2]});
  const Rational half = Rational(1) / (circle.square_normal * Rational(2));
  const Rational& t = exact(node);
  const RationalPoint3 first = quoin::exact_point(*p[0]);
  return {first.x + circle.centre.x * half + circle.normal.x * t,
          first.y + circle.centre.y * half + circle.normal.y * t,
          first.z + circle.centre.z * half + circle.normal.z * t};
}

// As RoundedRay bounds its errors: with k = |a| |b| / |n|, the centre from the first corner has 32 k u (|a| + |b|) and
// 17 k u of itself, n has 8 k u of itself, and the place its own error times n.
Point3 CrossingChain::near_point(std::uint32_t node, double part) {
  if (nodes_[node].state == State::unknown) round(node);
  const Node& at = nodes_[node];
  const auto p = corners(at.triangle);
  const Point3& first = *p[0];
  const auto difference = [&](const Point3& q) {
    return Vector<double>{(q.x - first.x) * scale_, (q.y - first.y) * scale_, (q.z - first.z) * scale_};
  };
  const auto norm = [](const Vector<double>& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); };
  const Vector<double> a = difference(*p[1]);
  const Vector<double> b = difference(*p[2]);
  const Vector<double> n = cross(a, b);
  const double nn = dot(n, n);
  const double k = norm(a) * norm(b) / std::sqrt(nn);
  const Vector<double> centre = cross(b * dot(a, a) - a * dot(b, b), n) * (1 / (2 * nn));
  const Vector<double> off = centre + n * at.place.t;
  const double error =
      1e-14 * k * (norm(centre) + norm(a) + norm(b) + std::fabs(at.place.t) * norm(n)) + at.place.error * norm(n);
  const double largest = std::max({std::fabs(first.x), std::fabs(first.y), std::fabs(first.z)}) * scale_;
  if (at.state == State::rounded && nn > 0x1p-160 && k < 0x1p26 && error < part / 4 * std::max(largest, norm(off))) {
    const double unscaled = 1 / scale_;
    return {first.x + off.x * unscaled, first.y + off.y * unscaled, first.z + off.z * unscaled};
  }
  const RationalPoint3 exact = exact_point(node);
  return {exact.x.to_double(), exact.y.to_double(), exact.z.to_double()};
}

}  // namespace quoin
