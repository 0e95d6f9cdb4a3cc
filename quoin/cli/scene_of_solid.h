// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/exit.h"
#include "quoin/view/scene.h"

namespace quoin::cli {

/// What the view shows of a solid: its faces with planes and origins, edges between faces, and the summary.
ViewScene scene_of_solid(const Brep& boundary, const Triangulated& triangles, const std::string& title,
                         const Context& context);

}  // namespace quoin::cli
