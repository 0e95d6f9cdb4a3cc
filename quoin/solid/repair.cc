// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/repair.h"

#include <algorithm>
#include <map>
#include <set>

#include "quoin/base/disjoint_sets.h"
#include "quoin/solid/leaf.h"
#include "quoin/solid/overlay/winding.h"

namespace quoin {

namespace {

class MeshRepair {
 public:
  MeshRepair(const Mesh& mesh, const Context& context) : mesh_(mesh), context_(context) {}

  RepairResult run() {
    drop_faces();
    context_.poll();
    link_faces();
    agree_with_neighbours();
    face_outward();
    report("degenerate faces dropped", degenerate_);
    report("duplicate faces dropped", duplicate_);
    std::size_t turned = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (reversed_[f]) {
        ++turned;
        std::reverse(faces_[f].begin(), faces_[f].end());
      }
    }
    report("faces turned over", turned);
    write_back();
    return std::move(result_);
  }

 private:
  void report(const std::string& what, std::size_t count) {
    if (count != 0) result_.changes.push_back(std::to_string(count) + " " + what);
  }

  // Repeated corners go; two faces with the same set of corners are duplicates, however they are turned.
  void drop_faces() {
    std::set<std::vector<std::uint32_t>> seen;
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      std::vector<std::uint32_t> corners;
      for (const std::uint32_t v : mesh_.face(f)) {
        if (corners.empty() || corners.back() != v) corners.push_back(v);
      }
      while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
      if (corners.size() < 3) {
        ++degenerate_;
        continue;
      }
      std::vector<std::uint32_t> key = corners;
      std::sort(key.begin(), key.end());
      if (!seen.insert(key).second) {
        ++duplicate_;
        continue;
      }
      faces_.push_back(std::move(corners));
      source_.push_back(f);
    }
  }

  struct Neighbour {
    std::uint32_t face;
    bool agrees;
  };

  void link_faces() {
    struct Use {
      std::uint32_t face;
      bool forward;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Use>> uses;
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      const auto& corners = faces_[f];
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t a = corners[i];
        const std::uint32_t b = corners[i + 1 == corners.size() ? 0 : i + 1];
        uses[{std::min(a, b), std::max(a, b)}].push_back({f, a < b});
      }
    }
    neighbours_.resize(faces_.size());
    for (const auto& [edge, at] : uses) {
      if (at.size() != 2) continue;
      const bool agrees = at[0].forward != at[1].forward;
      neighbours_[at[0].face].push_back({at[1].face, agrees});
      neighbours_[at[1].face].push_back({at[0].face, agrees});
    }
  }

  void agree_with_neighbours() {
    reversed_.assign(faces_.size(), false);
    component_.assign(faces_.size(), overlay::none);
    std::vector<std::uint32_t> stack;
    for (std::uint32_t seed = 0; seed < faces_.size(); ++seed) {
      if (component_[seed] != overlay::none) continue;
      component_[seed] = component_count_;
      stack.assign(1, seed);
      while (!stack.empty()) {
        const std::uint32_t f = stack.back();
        stack.pop_back();
        for (const Neighbour& n : neighbours_[f]) {
          if (component_[n.face] != overlay::none) continue;
          component_[n.face] = component_count_;
          reversed_[n.face] = reversed_[f] != !n.agrees;
          stack.push_back(n.face);
        }
      }
      ++component_count_;
    }
  }

  // Each component alone is a leaf; its winding in front of a face tells whether it is inside out, and how many others
  // lie around it tells whether it should be.
  void face_outward() {
    std::vector<std::shared_ptr<const Leaf>> leaves(component_count_);
    for (std::uint32_t c = 0; c < component_count_; ++c) {
      Mesh part;
      part.vertices = mesh_.vertices;
      for (std::uint32_t f = 0; f < faces_.size(); ++f) {
        if (component_[f] != c) continue;
        std::vector<std::uint32_t> corners = faces_[f];
        if (reversed_[f]) std::reverse(corners.begin(), corners.end());
        part.add_face(corners);
      }
      leaves[c] = make_leaf(part, {.max_listed = 0, .find_crossings = false}, context_).leaf;
      if (!leaves[c] || leaves[c]->tiles.empty()) return;  // open: no side is outside
    }
    const overlay::Subdivision nothing_cut;
    overlay::Scene scene = overlay::make_unpaired_scene(leaves);
    const overlay::Sheets sheets{&scene, nullptr, &nothing_cut};
    for (std::uint32_t c = 0; c < component_count_; ++c) {
      const overlay::SheetWinding winding = overlay::winding_at(sheets, scene.first_tile[c]);
      std::size_t around = 0;
      int own = 0;
      for (const overlay::Winding& w : winding.windings) {
        if (w.leaf == c)
          own = w.number;
        else if (w.number % 2 != 0)
          ++around;
      }
      const bool outward = winding.in_front ? own == 0 : own > 0;
      if (outward != (around % 2 == 0)) turn_component(c);
    }
  }

  void turn_component(std::uint32_t c) {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (component_[f] == c) reversed_[f] = !reversed_[f];
    }
  }

  void write_back() {
    result_.mesh.vertices = mesh_.vertices;
    result_.mesh.name = mesh_.name;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      result_.mesh.add_face(faces_[f]);
      if (!mesh_.face_colors.empty()) result_.mesh.face_colors.push_back(mesh_.face_colors[source_[f]]);
    }
  }

  const Mesh& mesh_;
  const Context& context_;
  RepairResult result_;
  std::vector<std::vector<std::uint32_t>> faces_;
  std::vector<std::size_t> source_;
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<bool> reversed_;
  std::vector<std::uint32_t> component_;
  std::uint32_t component_count_ = 0;
  std::size_t degenerate_ = 0;
  std::size_t duplicate_ = 0;
};

}  // namespace

RepairResult repair_mesh(const Mesh& mesh, const Context& context) {
  return MeshRepair(mesh, context).run();
}

}  // namespace quoin
