// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/overlay.h"

#include "quoin/solid/overlay/extraction.h"

namespace quoin {

Brep overlay_boundary(std::span<const std::shared_ptr<const Leaf>> leaves, const Expression& expression,
                      const Context& context) {
  using namespace overlay;
  Scene scene = make_scene(leaves, context);
  Network network = make_network(scene, context);
  const std::vector<PointOnCurve> crossings = find_crossings(scene, network, context);
  const Subdivision subdivision = subdivide(scene, network, crossings, context);
  const Sheets sheets{&scene, &network, &subdivision};
  const Fans fans = make_fans(sheets, scene, context);
  const CellComplex complex = make_cells(sheets, fans, context);
  const CellTruth truth = classify_cells(sheets, complex, expression, context);
  return extract_boundary(sheets, fans, complex, truth, context);
}

}  // namespace quoin
