// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/picture_labels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "quoin/view/face_pole.h"

namespace quoin {

namespace {

constexpr double face_font = 14;
constexpr double small_font = 11.5;
constexpr double smallest_font = 8;

const std::string& label_of(const PlanarPicture& picture, const LabelAnchor& anchor) {
  if (anchor.kind == CellKind::face) return picture.faces[anchor.cell].text.label;
  if (anchor.kind == CellKind::edge) return picture.edges[anchor.cell].text.label;
  return picture.points[anchor.cell].text.label;
}

LabelAnchor face_anchor(const PictureFace& face, std::size_t index, const PictureFrame& frame,
                        const PictureBox& sheet) {
  std::vector<std::vector<Point2>> polygons;
  for (const PicturePath& ring : face.rings) polygons.push_back(flattened(frame.ring(ring), 0.3));
  if (face.is_outside) polygons.push_back(flattened(frame.border(), 1));
  const Pole pole = pole_of(polygons, sheet, 1);
  return {CellKind::face, index, pole.at, pole.radius, {}};
}

/// The middle of the longest part that is seen.
LabelAnchor edge_anchor(const PictureEdge& edge, std::size_t index, const PictureFrame& frame,
                        const PictureBox& sheet) {
  const PictureBox seen{{-0.01, -0.01}, {sheet.high.x + 0.01, sheet.high.y + 0.01}};
  LabelAnchor anchor{CellKind::edge, index, {-1, -1}, 0, {0, -1}};
  double longest = 0;
  for (const PicturePath& part : frame.curve(edge.path)) {
    std::vector<Point2> points = flattened(part, 0.3);
    std::erase_if(points, [&](const Point2& p) { return !seen.contains(p); });
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    }
    if (length <= longest) continue;
    longest = length;
    double rest = length / 2;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double dx = points[i].x - points[i - 1].x;
      const double dy = points[i].y - points[i - 1].y;
      const double step = std::hypot(dx, dy);
      if (step >= rest && step > 0) {
        anchor.at = {points[i - 1].x + dx * rest / step, points[i - 1].y + dy * rest / step};
        anchor.aside = {dy / step, -dx / step};
        break;
      }
      rest -= step;
    }
  }
  if (anchor.aside.y > 0) anchor.aside = {-anchor.aside.x, -anchor.aside.y};
  return anchor;
}

/// What is taken on the sheet.
class Occupied {
 public:
  bool is_free(const PictureBox& box) const {
    return std::ranges::none_of(boxes_, [&](const PictureBox& other) {
      return box.low.x < other.high.x && other.low.x < box.high.x && box.low.y < other.high.y &&
             other.low.y < box.high.y;
    });
  }
  void take(const PictureBox& box) { boxes_.push_back(box); }

 private:
  std::vector<PictureBox> boxes_;
};

PictureBox box_around(const Point2& center, double half_width, double half_height) {
  return {{center.x - half_width, center.y - half_height}, {center.x + half_width, center.y + half_height}};
}

bool is_within(const PictureBox& inner, const PictureBox& outer) {
  return outer.contains(inner.low) && outer.contains(inner.high);
}

class Placement {
 public:
  Placement(const PlanarPicture& picture, const PictureFrame& frame)
      : picture_(picture), sheet_{{0, 0}, {frame.width(), frame.height()}} {
    for (const PicturePoint& point : picture.points) occupied_.take(box_around(frame.map(point.at), 2.5, 2.5));
  }

  void place(const LabelAnchor& anchor) {
    const double width = text_width(label_of(picture_, anchor));
    if (anchor.kind == CellKind::face) return place_in_face(anchor, width);
    const double half_width = small_font * width / 2;
    const double half_height = small_font * 0.55;
    for (const Point2& way : ways(anchor)) {
      const double gap = anchor.kind == CellKind::point ? 4 : 2;
      const Point2 at{anchor.at.x + way.x * (half_width + gap), anchor.at.y + way.y * (half_height + gap)};
      const PictureBox box = box_around(at, half_width, half_height);
      if (!is_within(box, sheet_) || !occupied_.is_free(box)) continue;
      occupied_.take(box);
      placed_.push_back({anchor, at, small_font});
      return;
    }
  }

  std::vector<PlacedLabel> take() { return std::move(placed_); }

 private:
  void place_in_face(const LabelAnchor& anchor, double width) {
    const double size = std::min(face_font, anchor.room / std::hypot(width / 2, 0.5));
    if (size < smallest_font) return;
    // In the middle, or where there still is room above or below something in the way.
    for (const double shift : {0.0, 0.5, -0.5}) {
      const Point2 at{anchor.at.x, anchor.at.y + shift * anchor.room};
      const double reach = std::hypot(size * width / 2, shift * anchor.room + std::copysign(size / 2, shift));
      const PictureBox box = box_around(at, size * width / 2, size / 2);
      if (reach > 1.001 * anchor.room || !occupied_.is_free(box)) continue;
      occupied_.take(box);
      placed_.push_back({anchor, at, size});
      return;
    }
  }

  static std::vector<Point2> ways(const LabelAnchor& anchor) {
    if (anchor.kind == CellKind::point) {
      return {{0.9, -0.9}, {-0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}};
    }
    return {anchor.aside, {-anchor.aside.x, -anchor.aside.y}};
  }

  const PlanarPicture& picture_;
  PictureBox sheet_;
  Occupied occupied_;
  std::vector<PlacedLabel> placed_;
};

}  // namespace

double text_width(std::string_view text) {
  const auto characters =
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return 0.62 * static_cast<double>(characters);
}

std::vector<LabelAnchor> label_anchors(const PlanarPicture& picture, const PictureFrame& whole) {
  const PictureFrame frame = whole.without_surroundings();
  const PictureBox& sheet = frame.region();
  std::vector<LabelAnchor> anchors;
  for (std::size_t i = 0; i < picture.faces.size(); ++i) {
    if (picture.faces[i].text.label.empty()) continue;
    const LabelAnchor anchor = face_anchor(picture.faces[i], i, frame, sheet);
    if (anchor.room > 0) anchors.push_back(anchor);
  }
  for (std::size_t i = 0; i < picture.points.size(); ++i) {
    const Point2 at = frame.map(picture.points[i].at);
    if (!picture.points[i].text.label.empty() && sheet.contains(at)) anchors.push_back({CellKind::point, i, at, 0, {}});
  }
  for (std::size_t i = 0; i < picture.edges.size(); ++i) {
    if (picture.edges[i].text.label.empty()) continue;
    const LabelAnchor anchor = edge_anchor(picture.edges[i], i, frame, sheet);
    if (sheet.contains(anchor.at)) anchors.push_back(anchor);
  }
  return anchors;
}

std::vector<PlacedLabel> place_labels(const PlanarPicture& picture, const PictureFrame& frame) {
  Placement placement(picture, frame);
  for (const LabelAnchor& anchor : label_anchors(picture, frame)) placement.place(anchor);
  return placement.take();
}

}  // namespace quoin
