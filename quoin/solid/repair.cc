// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/repair.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"
#include "quoin/solid/leaf.h"
#include "quoin/solid/one_sided_bands.h"
#include "quoin/solid/overlay/winding.h"
#include "quoin/solid/repair_duplicates.h"
#include "quoin/solid/repair_slivers.h"

namespace quoin {

namespace {

class MeshRepair {
 public:
  MeshRepair(const Mesh& mesh, const Context& context) : mesh_(mesh), context_(context) {}

  RepairResult run() {
    drop_degenerate_faces();
    drop_superfluous_faces();
    drop_superfluous_slivers();
    context_.poll();
    gather_edges();
    agree_with_neighbours();
    join_open_components();
    face_outward();
    turn_faces();
    write_back();
    return std::move(result_);
  }

 private:
  void report(const std::string& what, std::vector<std::uint32_t> faces) {
    if (!faces.empty()) result_.changes.push_back({what, std::move(faces)});
  }

  void drop_degenerate_faces() {
    std::vector<std::uint32_t> degenerate;
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      std::vector<std::uint32_t> corners;
      for (const std::uint32_t v : mesh_.face(f)) {
        if (v >= mesh_.vertices.size())
          throw InputError("face " + std::to_string(f) + ": vertex " + std::to_string(v) + " is not there");
        if (corners.empty() || corners.back() != v) corners.push_back(v);
      }
      while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
      if (corners.size() < 3) {
        degenerate.push_back(f);
        continue;
      }
      faces_.push_back(std::move(corners));
      source_.push_back(f);
    }
    report("degenerate faces dropped", std::move(degenerate));
  }

  void drop_superfluous_faces() {
    const SuperfluousFaces superfluous = find_superfluous_faces(faces_, context_);
    report("duplicate faces dropped", sources(superfluous.duplicates));
    report("faces dropped that lie back to back", sources(superfluous.balanced));
    drop(superfluous.duplicates);
    drop(superfluous.balanced);
    remove_dropped();
  }

  void drop_superfluous_slivers() {
    const std::vector<std::uint32_t> slivers = find_superfluous_slivers(mesh_.vertices, faces_, context_);
    report("faces dropped whose corners lie on a line", sources(slivers));
    drop(slivers);
    remove_dropped();
  }

  // Leaves a face without corners, which no other is.
  void drop(std::span<const std::uint32_t> faces) {
    for (const std::uint32_t f : faces) faces_[f].clear();
  }

  void remove_dropped() {
    std::size_t kept = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (faces_[f].empty()) continue;
      if (kept != f) faces_[kept] = std::move(faces_[f]);
      source_[kept++] = source_[f];
    }
    faces_.resize(kept);
    source_.resize(kept);
  }

  std::vector<std::uint32_t> sources(std::span<const std::uint32_t> faces) const {
    std::vector<std::uint32_t> result;
    for (const std::uint32_t f : faces) result.push_back(source_[f]);
    return result;
  }

  // A face at an edge, the edge by its vertices in ascending order.
  struct Use {
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t face;
    bool forward;
  };

  void gather_edges() {
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      const auto& corners = faces_[f];
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t a = corners[i];
        const std::uint32_t b = corners[i + 1 == corners.size() ? 0 : i + 1];
        uses_.push_back({std::min(a, b), std::max(a, b), f, a < b});
      }
    }
    std::sort(uses_.begin(), uses_.end(), [](const Use& x, const Use& y) {
      return x.a != y.a ? x.a < y.a : x.b != y.b ? x.b < y.b : x.face < y.face;
    });
  }

  template <class Visitor>
  void for_each_edge(const Visitor& visit) const {
    for (std::size_t begin = 0, end = 0; begin < uses_.size(); begin = end) {
      while (end < uses_.size() && uses_[end].a == uses_[begin].a && uses_[end].b == uses_[begin].b) ++end;
      visit(std::span(uses_).subspan(begin, end - begin));
    }
  }

  std::vector<FaceLink> links() const {
    std::vector<FaceLink> result;
    for_each_edge([&](std::span<const Use> at) {
      if (at.size() == 2) result.push_back({at[0].face, at[1].face, at[0].forward != at[1].forward});
    });
    return result;
  }

  // Each component goes the way of most of its faces; one that no orientation fits stays as it is.
  void agree_with_neighbours() {
    Orientation orientation = orient_faces(faces_.size(), links(), context_);
    component_ = std::move(orientation.component);
    component_count_ = orientation.component_count;
    std::vector<std::ptrdiff_t> excess(component_count_, 0);  // of turned faces over others
    for (std::size_t f = 0; f < faces_.size(); ++f) excess[component_[f]] += orientation.is_reversed[f] != 0 ? 1 : -1;
    reversed_.assign(faces_.size(), false);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const std::uint32_t c = component_[f];
      if (orientation.is_one_sided[c] == 0) reversed_[f] = (orientation.is_reversed[f] != 0) != (excess[c] > 0);
    }
    for (const std::vector<std::uint32_t>& band : orientation.one_sided_bands)
      result_.refusals.push_back({"faces in a cycle that turns over: no orientation fits", sources(band)});
  }

  // Components that do not close by themselves and meet in edges of more than two faces become one.
  void join_open_components() {
    std::vector<bool> is_open(component_count_, false);
    std::vector<int> balance(component_count_, 0);
    for_each_edge([&](std::span<const Use> at) {
      for (const Use& use : at) balance[component_[use.face]] += use.forward != reversed_[use.face] ? 1 : -1;
      for (const Use& use : at) {
        int& sum = balance[component_[use.face]];
        if (sum != 0) is_open[component_[use.face]] = true;
        sum = 0;
      }
    });
    DisjointSets joined(component_count_);
    for_each_edge([&](std::span<const Use> at) {
      std::uint32_t first = overlay::none;
      for (const Use& use : at) {
        const std::uint32_t c = component_[use.face];
        if (!is_open[c]) continue;
        if (first == overlay::none) first = c;
        joined.unite(first, c);
      }
    });
    std::vector<std::uint32_t> number(component_count_, overlay::none);
    std::uint32_t count = 0;
    for (std::uint32_t& c : component_) {
      std::uint32_t& n = number[joined.find(c)];
      if (n == overlay::none) n = count++;
      c = n;
    }
    component_count_ = count;
  }

  std::vector<std::vector<std::uint32_t>> faces_by_component() const {
    std::vector<std::vector<std::uint32_t>> result(component_count_);
    for (std::uint32_t f = 0; f < faces_.size(); ++f) result[component_[f]].push_back(f);
    return result;
  }

  Mesh part(std::span<const std::uint32_t> faces, std::vector<std::uint32_t>& number) const {
    Mesh result;
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t f : faces) {
      corners.clear();
      for (const std::uint32_t v : faces_[f]) {
        if (number[v] == overlay::none) {
          number[v] = static_cast<std::uint32_t>(result.vertices.size());
          result.vertices.push_back(mesh_.vertices[v]);
        }
        corners.push_back(number[v]);
      }
      if (reversed_[f]) std::reverse(corners.begin(), corners.end());
      result.add_face(corners);
    }
    for (const std::uint32_t f : faces) {
      for (const std::uint32_t v : faces_[f]) number[v] = overlay::none;
    }
    return result;
  }

  // Each closed component alone is a leaf; its winding in front of a face tells whether it is inside out, and how many
  // others lie around it tells whether it should be.
  void face_outward() {
    const std::vector<std::vector<std::uint32_t>> members = faces_by_component();
    std::vector<std::shared_ptr<const Leaf>> leaves;
    std::vector<std::uint32_t> component_of_leaf;
    std::vector<std::uint32_t> number(mesh_.vertices.size(), overlay::none);
    for (std::uint32_t c = 0; c < component_count_; ++c) {
      context_.poll();
      auto leaf = make_leaf(part(members[c], number), {.max_listed = 0, .find_crossings = false}, context_).leaf;
      if (!leaf || leaf->tiles.empty()) continue;  // open: no side is outside
      leaves.push_back(std::move(leaf));
      component_of_leaf.push_back(c);
    }
    const overlay::Subdivision nothing_cut;
    overlay::Scene scene = overlay::make_unpaired_scene(leaves, context_);
    const overlay::Sheets sheets{&scene, nullptr, &nothing_cut};
    for (std::uint32_t l = 0; l < leaves.size(); ++l) {
      context_.poll();
      const overlay::SheetWinding winding = overlay::winding_at(sheets, scene.first_tile[l]);
      std::size_t around = 0;
      int own = 0;
      for (const overlay::Winding& w : winding.windings) {
        if (w.leaf == l)
          own = w.number;
        else if (w.number % 2 != 0)
          ++around;
      }
      const bool outward = winding.in_front ? own == 0 : own > 0;
      if (outward == (around % 2 == 0)) continue;
      for (const std::uint32_t f : members[component_of_leaf[l]]) reversed_[f] = !reversed_[f];
    }
  }

  void turn_faces() {
    std::vector<std::uint32_t> turned;
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      if (!reversed_[f]) continue;
      turned.push_back(source_[f]);
      std::reverse(faces_[f].begin(), faces_[f].end());
    }
    report("faces turned over", std::move(turned));
  }

  void write_back() {
    result_.mesh.vertices = mesh_.vertices;
    result_.mesh.name = mesh_.name;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      result_.mesh.add_face(faces_[f]);
      if (!mesh_.face_colors.empty()) result_.mesh.face_colors.push_back(mesh_.face_colors[source_[f]]);
    }
    result_.source_face = std::move(source_);
  }

  const Mesh& mesh_;
  const Context& context_;
  RepairResult result_;
  std::vector<std::vector<std::uint32_t>> faces_;
  std::vector<std::uint32_t> source_;
  std::vector<Use> uses_;  // by edge
  std::vector<bool> reversed_;
  std::vector<std::uint32_t> component_;
  std::uint32_t component_count_ = 0;
};

}  // namespace

RepairResult repair_mesh(const Mesh& mesh, const Context& context) {
  return MeshRepair(mesh, context).run();
}

}  // namespace quoin
