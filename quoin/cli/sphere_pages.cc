// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/sphere_pages.h"

#include <fstream>

#include "quoin/base/error.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/targets.h"
#include "quoin/view/sphere_arrangement_picture.h"
#include "quoin/view/sphere_page.h"

namespace quoin::cli {

void require_sphere_pages(const Options& options) {
  for (const Target& target : targets_of(options)) {
    if (target.kind != Target::Kind::planar_page) {
      throw UsageError(target.name + ": arrangements on the sphere are written as pages (html)");
    }
  }
}

void write_sphere_pages(const GeodesicArrangement& arrangement, const ArrangementPictureOptions& how,
                        const Options& options) {
  if (options.outputs.empty()) return;
  ArrangementPictureOptions all = how;
  all.title = planar_title(options);
  all.number_faces = all.number_edges = all.number_vertices = options.labels;
  const SpherePicture picture = sphere_picture_of(arrangement, all);
  for (const Target& target : targets_of(options)) {
    if (target.is_stream()) {
      write_sphere_page(data_stream(), picture);
      flush_standard_output();
      continue;
    }
    std::ofstream file(target.name);
    if (!file) throw FileError(target.name + ": cannot be opened for writing");
    write_sphere_page(file, picture);
    if (!file.flush()) throw FileError(target.name + ": cannot be written");
  }
}

}  // namespace quoin::cli
