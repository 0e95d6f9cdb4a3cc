// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/planar_pictures.h"

#include <fstream>

#include "quoin/base/error.h"
#include "quoin/cli/streams.h"
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

}  // namespace

void write_picture(const PlanarPicture& picture, const Options& options) {
  for (const Target& target : targets_of(options)) {
    if (target.kind != Target::Kind::planar_page && target.kind != Target::Kind::picture) continue;
    if (target.is_stream()) {
      write_to(data_stream(), target, picture);
      flush_standard_output();
      continue;
    }
    std::ofstream file(target.name);
    if (!file) throw FileError(target.name + ": cannot be opened for writing");
    write_to(file, target, picture);
    if (!file.flush()) throw FileError(target.name + ": cannot be written");
  }
}

}  // namespace quoin::cli
