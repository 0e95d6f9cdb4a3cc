// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/sphere_page.h"

#include "quoin/base/error.h"
#include "quoin/view/base64.h"
#include "quoin/view/built_templates.h"
#include "quoin/view/cells_json.h"
#include "quoin/view/page.h"
#include "quoin/view/page_text.h"

namespace quoin {

namespace {

template <class List, class Write>
void write_member(std::ostream& out, std::string_view name, const List& list, const Write& write) {
  out << ",\n\"" << name << "\":";
  page_text::write_json_list(out, list, write);
}

/// Runs of equal pixels, each as its face and its length: u32, little-endian, in base64.
void write_map(std::ostream& out, const FaceMap& map) {
  out << "<script type=\"text/plain\" id=\"quoin-map\">";
  Base64Writer block(out);
  for (std::size_t begin = 0, end = 0; begin < map.faces.size(); begin = end) {
    while (end < map.faces.size() && map.faces[end] == map.faces[begin]) ++end;
    block.put(map.faces[begin]);
    block.put(static_cast<std::uint32_t>(end - begin));
  }
  block.finish();
  out << "</script>\n";
}

/// Three numbers for each direction.
void write_directions(std::ostream& out, std::string_view id, const std::vector<Vector3>& directions) {
  out << "<script type=\"text/plain\" id=\"" << id << "\">";
  Base64Writer block(out);
  for (const Vector3& v : directions) {
    for (const double c : {v.x, v.y, v.z}) block.put(static_cast<float>(c));
  }
  block.finish();
  out << "</script>\n";
}

void write_data(std::ostream& out, const SpherePicture& picture) {
  CellsJson json(out);
  out << "<script type=\"application/json\" id=\"quoin-sphere\">{\"format\":\"quoin-sphere\",\"version\":1,";
  json.write_head(picture.title, picture.facts, picture.categories);
  out << ",\"map\":[";
  page_text::write_number(out, picture.map.width);
  out << ',';
  page_text::write_number(out, picture.map.height);
  out << ']';
  write_member(out, "faces", picture.faces, [&](const SphereFace& f) { json.write_cell(f.text, f.fill); });
  write_member(out, "edges", picture.edges, [&](const SphereEdge& e) { json.write_cell(e.text, e.stroke); });
  write_member(out, "points", picture.points, [&](const SpherePoint& p) { json.write_cell(p.text, p.fill); });
  write_member(out, "lengths", picture.edges,
               [&](const SphereEdge& e) { page_text::write_number(out, e.path.size()); });
  write_member(out, "styles", picture.edges,
               [&](const SphereEdge& e) { page_text::write_number(out, static_cast<int>(e.style)); });
  out << ",\n";
  json.write_colors();
  out << "}</script>\n";
}

}  // namespace

void write_sphere_page(std::ostream& out, const SpherePicture& picture) {
  if (!has_view()) throw Error("the browser view was not built into this quoin (configure with -DQUOIN_VIEW=ON)");
  write_sphere_page(out, picture, built_sphere_template());
}

void write_sphere_page(std::ostream& out, const SpherePicture& picture, std::string_view page_template) {
  const page_text::Template page = page_text::split_template(page_template);
  check_picture(picture);
  out << page.before_title;
  page_text::write_title(out, picture.title);
  out << page.before_scene;
  write_sphere_blocks(out, picture);
  out << page.rest;
}

void write_sphere_blocks(std::ostream& out, const SpherePicture& picture) {
  std::vector<Vector3> points;
  for (const SpherePoint& point : picture.points) points.push_back(point.at);
  std::vector<Vector3> paths;
  for (const SphereEdge& edge : picture.edges) paths.insert(paths.end(), edge.path.begin(), edge.path.end());
  write_data(out, picture);
  write_directions(out, "quoin-points", points);
  write_directions(out, "quoin-paths", paths);
  write_map(out, picture.map);
}

}  // namespace quoin
