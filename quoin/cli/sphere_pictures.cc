// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/sphere_pictures.h"

#include "quoin/cli/failure.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/target_writing.h"
#include "quoin/cli/targets.h"
#include "quoin/view/flat_sphere_picture.h"
#include "quoin/view/picture_svg.h"
#include "quoin/view/sphere_arrangement_picture.h"
#include "quoin/view/sphere_page.h"

namespace quoin::cli {

void require_pictures(const Options& options) {
  for (const Target& target : targets_of(options)) {
    if (target.kind != Target::Kind::planar_page && target.kind != Target::Kind::picture) {
      throw UsageError(target.name + ": what is on a sphere or cube is written as pictures (svg, html)");
    }
  }
}

void write_sphere_pictures(const GeodesicArrangement& arrangement, const ArrangementPictureOptions& how,
                           const Options& options, const Context& context) {
  if (options.outputs.empty()) return;
  ArrangementPictureOptions all = how;
  all.title = planar_title(options);
  all.number_faces = all.number_edges = all.number_vertices = options.labels;
  for (const Target& target : targets_of(options)) {
    if (target.kind == Target::Kind::picture) {
      const PlanarPicture flat = flat_picture_of(arrangement, all, context);
      write_target(target, [&](std::ostream& out) { write_svg(out, flat); });
    } else {
      const SpherePicture globe = sphere_picture_of(arrangement, all);
      write_target(target, [&](std::ostream& out) { write_sphere_page(out, globe); });
    }
  }
}

}  // namespace quoin::cli
