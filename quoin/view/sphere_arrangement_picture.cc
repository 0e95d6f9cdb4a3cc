// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/sphere_arrangement_picture.h"

#include <array>
#include <charconv>

#include "quoin/base/error.h"
#include "quoin/view/cell_texts.h"

namespace quoin {

namespace {

using dcel::Dcel;
using dcel::EdgeId;
using dcel::FaceId;
using dcel::VertexId;

std::string rounded(const Vector3& v) {
  std::string text = "≈ (";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<char, 32> digits;
    const double value = v[axis] == 0 ? 0.0 : v[axis];
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 6).ptr;
    text.append(digits.data(), end);
    text += axis < 2 ? ", " : ")";
  }
  return text;
}

PictureText joined(PictureText own, const PictureText& callers, bool is_numbered, std::size_t number) {
  if (!callers.name.empty()) own.name = callers.name;
  own.label = callers.label.empty() && is_numbered ? std::to_string(number) : callers.label;
  own.facts.insert(own.facts.begin(), callers.facts.begin(), callers.facts.end());
  return own;
}

class SphereArrangementPicture {
 public:
  SphereArrangementPicture(const Dcel& cells, const CurveHistory& history, const SpherePlaces& places,
                           const ArrangementPictureOptions& options)
      : cells_(cells), places_(places), options_(options), texts_(cells, history, options.curve_name) {
    picture_.title = options.title;
    picture_.facts = texts_.of_whole();
    add_faces();
    add_edges();
    add_vertices();
  }

  SpherePicture take_cells() { return std::move(picture_); }

  SpherePicture take_picture(const LocateOnSphere& locate, std::uint32_t map_width) {
    fill_face_map(picture_, map_width, [&](const std::vector<Vector3>& directions) {
      std::vector<std::uint32_t> faces;
      for (const FaceId f : locate(directions)) {
        if (!f.is_none() && f.index() >= index_.size()) throw InputError("picture of a sphere: no such face");
        faces.push_back(f.is_none() ? FaceMap::no_face : index_[f.index()]);
      }
      return faces;
    });
    return std::move(picture_);
  }

 private:
  void add_faces() {
    const std::vector<std::uint32_t> colors =
        options_.face ? std::vector<std::uint32_t>() : colors_by_neighbours(cells_);
    index_.assign(cells_.faces.size(), FaceMap::no_face);
    for (std::size_t i = 0; i < cells_.faces.size(); ++i) {
      const FaceId f(i);
      if (!cells_.is_real(f)) continue;
      index_[i] = static_cast<std::uint32_t>(picture_.faces.size());
      const CellLook look = options_.face ? options_.face(f) : CellLook{{colors[i], {}}, {}, {}};
      PictureText text = texts_.of(f);
      text.facts.erase(text.facts.begin());  // all faces are bounded
      picture_.faces.push_back({look.fill, joined(std::move(text), look.text, options_.number_faces, i)});
    }
  }

  void add_edges() {
    for (std::size_t i = 0; i < cells_.edges.size(); ++i) {
      const EdgeId e(i);
      if (!cells_.is_real(e)) continue;
      const CellLook look = options_.edge ? options_.edge(e) : CellLook{};
      picture_.edges.push_back(
          {places_.edges[i], look.style, look.fill, joined(texts_.of(e), look.text, options_.number_edges, i)});
    }
  }

  void add_vertices() {
    for (std::size_t i = 0; i < cells_.vertices.size(); ++i) {
      const VertexId v(i);
      if (!cells_.is_real(v)) continue;
      const CellLook look = options_.vertex ? options_.vertex(v) : CellLook{};
      PictureText text = texts_.of(v, {});
      text.facts.front().second = rounded(places_.vertices[i]);
      picture_.points.push_back(
          {places_.vertices[i], look.fill, joined(std::move(text), look.text, options_.number_vertices, i)});
    }
  }

  const Dcel& cells_;
  const SpherePlaces& places_;
  const ArrangementPictureOptions& options_;
  CellTexts texts_;
  SpherePicture picture_;
  std::vector<std::uint32_t> index_;  // of faces in the picture
};

}  // namespace

SpherePicture sphere_cells_of(const Dcel& cells, const CurveHistory& history, const SpherePlaces& places,
                              const ArrangementPictureOptions& options) {
  return SphereArrangementPicture(cells, history, places, options).take_cells();
}

SpherePicture sphere_picture_of_cells(const Dcel& cells, const CurveHistory& history, const SpherePlaces& places,
                                      const ArrangementPictureOptions& options, const LocateOnSphere& locate,
                                      std::uint32_t map_width) {
  return SphereArrangementPicture(cells, history, places, options).take_picture(locate, map_width);
}

}  // namespace quoin
