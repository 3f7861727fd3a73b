// SPDX-License-Identifier: GPL-3.0-or-later
// Bases of shapes: deviations of drawn vertices.
#include "app/web/shapes/shape_basis.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace torsio::web {
namespace {

/// A tube of radius 30 and length 200 rotated by `angle` at its far end, mm.
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

/// Largest deviation of the shape as a page computes it.
float farthestDrawn(const ShapeBasis& basis, const std::vector<float>& weights,
                    const std::vector<float>& shape) {
  float farthest = 0.0F;
  for (std::size_t vertex = 0; vertex < shape.size(); vertex += 3) {
    float square = 0.0F;
    for (std::size_t i = vertex; i < vertex + 3; ++i) {
      float place = basis.mean[i];
      for (std::size_t k = 0; k < weights.size(); ++k) {
        place += weights[k] * basis.scale[k] * static_cast<float>(basis.steps[k * shape.size() + i]);
      }
      square += (place - shape[i]) * (place - shape[i]);
    }
    farthest = std::max(farthest, std::sqrt(square));
  }
  return farthest;
}

TEST(ShapeBasis, ReproducesEveryShapeWithinTheBound) {
  std::vector<std::vector<float>> shapes;
  for (int i = 0; i <= 61; ++i) {
    shapes.push_back(tube(i * 0.05));
  }
  ShapeFitter fitter(shapes.front(), 0.15F, 40);
  fitter.learn(std::vector<std::vector<float>>{shapes[0], shapes[20], shapes[40], shapes[61]}, 0.15F);
  const std::size_t learnt = fitter.basis().components();

  const std::vector<ShapeFitter::Fit> fits = fitter.fit(shapes);

  ASSERT_EQ(fits.size(), shapes.size());
  EXPECT_GE(fitter.basis().components(), learnt);
  EXPECT_LT(fitter.basis().components(), 20U);
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const float drawn = farthestDrawn(fitter.basis(), fits[s].weights, shapes[s]);
    EXPECT_LE(drawn, 0.15F + 1e-3F) << s;
    EXPECT_NEAR(fits[s].farthest, drawn, 1e-3F) << "what is told is what is drawn";
    for (const float weight : fits[s].weights) {
      EXPECT_NEAR(weight / kWeightStep_mm, std::round(weight / kWeightStep_mm), 1e-2F);
    }
  }
}

TEST(ShapeBasis, LearnsNothingTwice) {
  std::vector<std::vector<float>> shapes;
  for (int i = 0; i <= 30; ++i) {
    shapes.push_back(tube(i * 0.1));
  }
  ShapeFitter fitter(shapes.front(), 0.15F, 40);
  fitter.learn(shapes, 0.15F);
  const std::size_t learnt = fitter.basis().components();

  fitter.learn(shapes, 0.15F);
  EXPECT_EQ(fitter.basis().components(), learnt);
  shapes.push_back(tube(1.0));
  for (std::size_t i = 0; i < shapes.back().size(); i += 3) {
    shapes.back()[i] += 10.0F;  // not a rotation
  }
  fitter.learn(shapes, 0.15F);

  EXPECT_GT(fitter.basis().components(), learnt);
  EXPECT_LE(fitter.basis().components(), learnt + 2);
  for (const ShapeFitter::Fit& fit : fitter.fit(shapes)) {
    for (const float weight : fit.weights) {
      EXPECT_LT(std::abs(weight), 100.0F) << "no components that cancel each other";
    }
  }
}

TEST(ShapeBasis, CanBeSplitIntoTwoParts) {
  const std::vector<std::vector<float>> shapes{tube(0.0), tube(1.0), tube(2.0), tube(3.0)};
  ShapeFitter fitter(shapes.front(), 0.05F, 40);
  fitter.learn(shapes, 0.15F);
  const ShapeBasis& whole = fitter.basis();
  ASSERT_GE(whole.components(), 2U);

  const ShapeBasis first = whole.upTo(1);
  const ShapeBasis others = whole.from(1);

  EXPECT_EQ(first.mean, whole.mean);
  EXPECT_EQ(first.components() + others.components(), whole.components());
  std::vector<std::int16_t> steps = first.steps;
  steps.insert(steps.end(), others.steps.begin(), others.steps.end());
  EXPECT_EQ(steps, whole.steps);
  EXPECT_EQ(whole.from(whole.components()).components(), 0U);
}

TEST(ShapeBasis, OneShapeNeedsNoComponent) {
  const std::vector<std::vector<float>> shapes{tube(0.3), tube(0.3)};
  ShapeFitter fitter(shapes.front(), 0.1F, 40);

  const std::vector<ShapeFitter::Fit> fits = fitter.fit(shapes);

  EXPECT_EQ(fitter.basis().components(), 0U);
  EXPECT_LE(fits[1].farthest, 0.01F) << "the mean is rounded";
}

TEST(ShapeBasis, StopsAtTheMaximumAndReturnsTheDeviation) {
  const std::vector<std::vector<float>> shapes{tube(0.0), tube(1.0), tube(2.0), tube(3.0)};
  ShapeFitter fitter(shapes.front(), 0.05F, 2);

  const std::vector<ShapeFitter::Fit> fits = fitter.fit(shapes);

  EXPECT_EQ(fitter.basis().components(), 2U);
  EXPECT_GT(fits.back().farthest, 0.05F);
}

}  // namespace
}  // namespace torsio::web
