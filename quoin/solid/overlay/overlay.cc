// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/overlay.h"

#include "quoin/solid/overlay/extraction.h"
#include "quoin/solid/overlay/winding_cells.h"

namespace quoin {

namespace {

template <class Classify>
Brep boundary_of_cells(std::span<const std::shared_ptr<const Leaf>> leaves, const Classify& classify,
                       const Context& context) {
  using namespace overlay;
  Scene scene = make_scene(leaves, context);
  Network network = make_network(scene, context);
  const std::vector<PointOnCurve> crossings = find_crossings(scene, network, context);
  const Subdivision subdivision = subdivide(scene, network, crossings, context);
  const Sheets sheets{&scene, &network, &subdivision};
  const Fans fans = make_fans(sheets, scene, context);
  const CellComplex complex = make_cells(sheets, fans, context);
  const CellTruth truth = classify(sheets, complex);
  return extract_boundary(sheets, fans, complex, truth, context);
}

}  // namespace

Brep overlay_boundary(std::span<const std::shared_ptr<const Leaf>> leaves, const Expression& expression,
                      const Context& context) {
  const auto classify = [&](const overlay::Sheets& sheets, const overlay::CellComplex& complex) {
    return overlay::classify_cells(sheets, complex, expression, context);
  };
  return boundary_of_cells(leaves, classify, context);
}

Brep winding_boundary(const std::shared_ptr<const Leaf>& leaf, CellVerdict kind, const CellQuestion& question,
                      const Context& context) {
  const auto classify = [&](const overlay::Sheets& sheets, const overlay::CellComplex& complex) {
    return overlay::classify_winding_cells(sheets, complex, kind, question, context);
  };
  return boundary_of_cells({&leaf, 1}, classify, context);
}

}  // namespace quoin
