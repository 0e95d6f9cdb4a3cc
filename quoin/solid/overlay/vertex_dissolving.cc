// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/vertex_dissolving.h"

#include <algorithm>
#include <utility>

namespace quoin::overlay {

namespace {

constexpr std::uint32_t none = PointId::none_value;

// The two neighbours that all passes of loops through a vertex have in common, and a face of one pass.
struct Neighbours {
  std::uint32_t a = none;
  std::uint32_t b = none;
  std::uint32_t face = none;
  bool are_common = true;
};

template <class Visit>  // visit(vertex, before, after, face); not for loops of three
void for_each_pass(const Brep& brep, const Visit& visit) {
  for (std::uint32_t face = 0; face < brep.face_count(); ++face) {
    for (std::uint32_t l = brep.face_first_loop[face]; l < brep.face_first_loop[face + 1]; ++l) {
      const auto loop = brep.loop(l);
      if (loop.size() == 3) continue;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        visit(loop[i].value, loop[i == 0 ? loop.size() - 1 : i - 1].value, loop[i + 1 == loop.size() ? 0 : i + 1].value,
              face);
      }
    }
  }
}

// The vertices of loops of more than three by numbers of their own, since most points of the table are none. A corner
// of a triangle is no inner point of a straight line.
class Candidates {
 public:
  Candidates(const Brep& brep, const std::vector<std::uint8_t>& is_corner) : number_(is_corner.size(), none) {
    for (std::size_t l = 0; l < brep.loop_count(); ++l) {
      const auto loop = brep.loop(l);
      if (loop.size() == 3) continue;
      for (const PointId p : loop) {
        if (is_corner[p.value] == 0 && number_[p.value] == none) number_[p.value] = count_++;
      }
    }
    for (std::size_t l = 0; l < brep.loop_count(); ++l) {
      const auto loop = brep.loop(l);
      if (loop.size() != 3) continue;
      for (const PointId p : loop) number_[p.value] = none;
    }
  }

  std::size_t count() const { return count_; }
  std::uint32_t number(std::uint32_t point) const { return number_[point]; }

 private:
  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> number_;
};

std::vector<Neighbours> common_neighbours(const Brep& brep, const Candidates& candidates) {
  std::vector<Neighbours> result(candidates.count());
  for_each_pass(brep, [&](std::uint32_t v, std::uint32_t before, std::uint32_t after, std::uint32_t face) {
    if (candidates.number(v) == none) return;
    Neighbours& n = result[candidates.number(v)];
    const auto [a, b] = std::minmax(before, after);
    if (n.face == none) n = {a, b, face, a != b};
    if (n.a != a || n.b != b) n.are_common = false;
  });
  return result;
}

bool planes_differ(const Constructions& table, const std::array<PointId, 3>& a, const std::array<PointId, 3>& b) {
  return std::any_of(b.begin(), b.end(),
                     [&](PointId p) { return table.orientation(a[0], a[1], a[2], p) != Sign::zero; });
}

// Where faces in two different planes pass between the same neighbours, both edges lie on the line that the planes
// share.
std::vector<bool> find_straight(const Constructions& table, const Brep& brep, const Candidates& candidates) {
  const std::vector<Neighbours> neighbours = common_neighbours(brep, candidates);
  std::vector<bool> straight(neighbours.size(), false);
  for_each_pass(brep, [&](std::uint32_t v, std::uint32_t, std::uint32_t, std::uint32_t face) {
    const std::uint32_t c = candidates.number(v);
    if (c == none || straight[c]) return;
    const Neighbours& n = neighbours[c];
    if (!n.are_common || face == n.face) return;
    if (planes_differ(table, brep.face_planes[n.face], brep.face_planes[face])) straight[c] = true;
  });
  return straight;
}

}  // namespace

void dissolve_vertices(const Constructions& table, const std::vector<std::uint8_t>& is_corner, Brep& brep) {
  const Candidates candidates(brep, is_corner);
  if (candidates.count() == 0) return;
  const std::vector<bool> straight = find_straight(table, brep, candidates);
  const auto is_straight = [&](PointId p) {
    const std::uint32_t c = candidates.number(p.value);
    return c != none && straight[c];
  };
  std::uint32_t kept = 0;
  std::uint32_t read = 0;
  for (std::size_t l = 0; l + 1 < brep.loop_begin.size(); ++l) {
    for (; read < brep.loop_begin[l + 1]; ++read) {
      const PointId p = brep.loop_vertices[read];
      if (!is_straight(p)) brep.loop_vertices[kept++] = p;
    }
    brep.loop_begin[l + 1] = kept;
  }
  brep.loop_vertices.resize(kept);
}

}  // namespace quoin::overlay
