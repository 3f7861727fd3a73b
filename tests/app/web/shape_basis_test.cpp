// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of an organ as a few displacements: how far a drawn vertex may lie off.
#include "app/web/shape_basis.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace torsio::web {
namespace {

/// A tube of radius 30 and length 200 that is turned by `angle` at its far end, mm.
std::vector<float> tube(double angle) {
  std::vector<float> places;
  for (int ring = 0; ring <= 20; ++ring) {
    for (int side = 0; side < 16; ++side) {
      const double along = ring / 20.0;
      const double around = side * 0.392699081698724 + angle * along;
      places.push_back(static_cast<float>(30.0 * std::cos(around)));
      places.push_back(static_cast<float>(30.0 * std::sin(around)));
      places.push_back(static_cast<float>(200.0 * along));
    }
  }
  return places;
}

TEST(ShapeBasis, ShowsEveryShapeWithinTheBound) {
  std::vector<std::vector<float>> shapes;
  for (int i = 0; i <= 60; ++i) {
    shapes.push_back(tube(i * 0.05));
  }

  const ShapeBasis basis = shapeBasis(shapes, 0.1F, 40);

  EXPECT_LT(basis.components(), 16U);
  for (const std::vector<float>& shape : shapes) {
    EXPECT_LE(basis.farthest(shape, basis.weightsOf(shape)), 0.15F);
  }
  const std::vector<float> between = tube(1.234);
  EXPECT_LE(basis.farthest(between, basis.weightsOf(between)), 0.15F)
      << "shapes that were not in the training";
}

TEST(ShapeBasis, OneShapeNeedsNoComponent) {
  const ShapeBasis basis = shapeBasis(std::vector<std::vector<float>>{tube(0.3), tube(0.3)}, 0.1F, 40);

  EXPECT_EQ(basis.components(), 0U);
  EXPECT_EQ(basis.farthest(tube(0.3), {}), 0.0F);
}

TEST(ShapeBasis, StopsAtTheMostComponents) {
  std::vector<std::vector<float>> shapes{tube(0.0), tube(1.0), tube(2.0), tube(3.0)};

  EXPECT_EQ(shapeBasis(shapes, 0.0F, 2).components(), 2U);
}

}  // namespace
}  // namespace torsio::web
