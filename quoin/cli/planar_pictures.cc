// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/planar_pictures.h"

#include <array>

#include "quoin/cli/target_writing.h"
#include "quoin/cli/targets.h"
#include "quoin/view/picture_page.h"
#include "quoin/view/picture_svg.h"

namespace quoin::cli {

namespace {

void write_to(std::ostream& out, const Target& target, const PlanarPicture& picture) {
  if (target.kind == Target::Kind::planar_page) {
    write_picture_page(out, picture);
  } else {
    write_svg(out, picture);
  }
}

bool holds(const LinearPolygonSet& set, const SourceCell& cell) {
  switch (cell.kind) {
    case SourceCell::Kind::vertex:
      return set.contains(dcel::VertexId(std::size_t{cell.id}));
    case SourceCell::Kind::edge:
      return set.contains(dcel::EdgeId(std::size_t{cell.id}));
    case SourceCell::Kind::face:
      break;
  }
  return set.contains(dcel::FaceId(std::size_t{cell.id}));
}

}  // namespace

void write_sum_picture(const LinearPolygonSet& sum, const LinearPolygonSet& tight, const Options& options,
                       const Context& context) {
  if (options.outputs.empty()) return;
  const std::array sources{&sum.arrangement(), &tight.arrangement()};
  const Overlay<LinearFamily> all = overlay<LinearFamily>(sources, context);
  ArrangementPictureOptions how;
  how.title = planar_title(options);
  how.number_vertices = options.labels;
  how.face = [&](dcel::FaceId f) {
    CellLook look;
    const bool is_member = holds(sum, all.source(f, 0));
    if (is_member) look.fill.category = 0;
    look.text.facts.emplace_back("Member", is_member ? "yes" : "no");
    return look;
  };
  const auto look_of = [&](bool is_tight) {
    CellLook look;
    if (is_tight) look.fill.category = 3;
    if (is_tight) look.text.facts.emplace_back("Tight", "yes");
    return look;
  };
  how.edge = [&](dcel::EdgeId e) {
    CellLook look = look_of(holds(tight, all.source(e, 1)));
    if (look.fill.category) look.style = EdgeStyle::strong;
    return look;
  };
  how.vertex = [&](dcel::VertexId v) { return look_of(holds(tight, all.source(v, 1))); };
  write_picture(picture_of(all.arrangement(), how), options);
}

void write_picture(const PlanarPicture& picture, const Options& options) {
  for (const Target& target : targets_of(options)) {
    if (target.kind != Target::Kind::planar_page && target.kind != Target::Kind::picture) continue;
    write_target(target, [&](std::ostream& out) { write_to(out, target, picture); });
  }
}

}  // namespace quoin::cli
