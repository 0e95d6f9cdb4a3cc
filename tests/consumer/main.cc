// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <iostream>

#include "quoin/solid/measure.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"

int main() {
  const quoin::Context context;
  const auto solid = [&](const quoin::Mesh& mesh) {
    return quoin::Solid::of_leaf(quoin::make_leaf(mesh, {}, context).leaf);
  };
  const std::array solids{solid(quoin::shapes::box({0, 0, 0}, {4, 4, 4})),
                          solid(quoin::shapes::box({1, 1, 3}, {2, 2, 6}))};
  const quoin::Rational volume = quoin::volume(quoin::intersect(solids, context).boundary(), context);
  std::cout << "volume " << volume.to_string() << "\n";
  return volume == quoin::Rational(1) ? 0 : 1;
}
