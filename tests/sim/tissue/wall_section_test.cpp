// SPDX-License-Identifier: GPL-3.0-or-later
// Closed walls by Bredt's formula on the middle line, against the membrane solver with the wall's inner
// outline as a hole. The solver's own bracket is 2e-4 of J.
#include "sim/tissue/section/wall_section.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/tissue/section/section_solver.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

constexpr int kPoints = 180;

/// A closed curve as kPoints chords of equal length.
std::vector<Point2> outlineOf(const std::function<Point2(double)>& curve) {
  constexpr int kFine = 7200;
  std::vector<Point2> fine;
  std::vector<double> way{0.0};
  for (int i = 0; i <= kFine; ++i) {
    fine.push_back(curve(kTurn * i / kFine));
    if (i > 0) {
      const Point2& a = fine[fine.size() - 2];
      way.push_back(way.back() + std::hypot(fine.back()[0] - a[0], fine.back()[1] - a[1]));
    }
  }
  std::vector<Point2> points;
  std::size_t at = 0;
  for (int k = 0; k < kPoints; ++k) {
    while (way[at + 1] < way.back() * k / kPoints) {
      ++at;
    }
    points.push_back(fine[at]);
  }
  return points;
}

struct Shape {
  std::string name;
  std::function<Point2(double)> curve;
};

Point2 polar(double radius, double stretch, double angle) {
  return {stretch * radius * std::cos(angle), radius * std::sin(angle)};
}

std::vector<Shape> shapes() {
  const auto kidney = [](double a) {
    const double dent = (a - 0.5 * kPi) / 0.45;
    return polar(1.0 - 0.5 * std::exp(-dent * dent), 1.3, a);
  };
  return {
      {"circle", [](double a) { return polar(1.0, 1.0, a); }},
      {"ellipse 1.5:1",
       [](double a) {
         return Point2{1.2247 * std::cos(a), 0.8165 * std::sin(a)};
       }},
      {"ellipse 2:1",
       [](double a) {
         return Point2{1.4142 * std::cos(a), 0.70711 * std::sin(a)};
       }},
      {"bean",
       [](double a) { return polar(1.0 + 0.45 * std::cos(a) * std::cos(a) - 0.35 * std::sin(a), 1.0, a); }},
      {"kidney", kidney}};
}

TEST(WallSection, AgreesWithTheSolverWithAHoleWithinOneInAHundred) {
  for (const Shape& shape : shapes()) {
    const std::vector<Point2> outline = outlineOf(shape.curve);
    const double radius = perimeter(outline) / kTurn;
    for (const double share : {0.02, 0.05, 0.10, 0.20, 0.30}) {
      const double thickness[] = {share * radius};
      const std::vector<std::vector<Point2>> hole{innerOutline(outline, thickness[0])};

      const WallSection wall = wallSection(outline, thickness);

      const SectionProperties solved = solveSection(outline, {}, hole);
      const double tolerance = share <= 0.2 ? 0.005 : 0.0115;  // by the solver 0.0102 at most
      EXPECT_NEAR(wall.torsionConstant / solved.torsionConstant, 1.0, tolerance)
          << shape.name << ' ' << share;
      EXPECT_NEAR(wall.area / solved.area, 1.0, 1e-3) << shape.name << ' ' << share;
    }
  }
}

TEST(WallSection, OfARoundTubeIsTheClosedFormButForTheStrip) {
  // J = 2 pi R^3 t (1 + t^2 / (4 R^2)) exactly; the strip's third in place of a quarter adds t^2 / (12 R^2).
  constexpr int kMany = 2000;
  std::vector<Point2> outline;
  for (int i = 0; i < kMany; ++i) {
    outline.push_back(polar(1.05, 1.0, kTurn * i / kMany));
  }
  const double thickness[] = {0.1};

  const WallSection wall = wallSection(outline, thickness);

  EXPECT_NEAR(wall.radius, 1.0, 1e-5);
  EXPECT_NEAR(wall.torsionConstant, kTurn * 0.1 * (1.0 + 0.01 / 3.0), 2e-5);
  EXPECT_NEAR(wall.area, kTurn * 0.1, 1e-5);
  EXPECT_NEAR(wall.maxShear, 1.0, 0.005);
  EXPECT_NEAR(wall.mostThickness, 1.05, 0.005);
}

TEST(WallSection, TakesAThicknessForEachPoint) {
  // R = 1 on the middle line, t = 0.05 (1 + 0.5 cos): closed integral of ds / t = 2 pi / (0.05 sqrt(1 -
  // 0.25)), of t^3 ds = 2 pi 0.05^3 (1 + 1.5 * 0.25).
  constexpr int kMany = 2000;
  std::vector<Point2> outline;
  std::vector<double> thickness;
  for (int i = 0; i < kMany; ++i) {
    const double angle = kTurn * i / kMany;
    outline.push_back(polar(1.025, 1.0, angle));
    thickness.push_back(0.05 * (1.0 + 0.5 * std::cos(angle)));
  }

  const WallSection wall = wallSection(outline, thickness);

  const double bredt = 4.0 * kPi * kPi / (kTurn / (0.05 * std::sqrt(0.75)));
  const double strip = kTurn * 0.05 * 0.05 * 0.05 * 1.375 / 3.0;
  EXPECT_NEAR(wall.torsionConstant / (bredt + strip), 1.0, 1e-4);
  EXPECT_NEAR(wall.thickest, 0.075, 1e-12);
}

TEST(WallSection, RefusesAWallThatLeavesNoTube) {
  const std::vector<Point2> outline = outlineOf(shapes()[0].curve);
  const auto refused = [&](std::vector<double> thickness) {
    return testing::refusalCode([&] { return wallSection(outline, thickness); }) == ErrorCode::kBadParameter;
  };

  EXPECT_TRUE(refused({0.0}));
  EXPECT_TRUE(refused({-1.0}));
  EXPECT_TRUE(refused({std::nan("")}));
  EXPECT_TRUE(refused({0.4}));  // 0.5 of the middle line's radius
  EXPECT_TRUE(refused({0.1, 0.1}));
  EXPECT_TRUE(refused({1e-320}));
  EXPECT_FALSE(refused({0.3}));
}

TEST(WallSection, RefusesAWallThatIsThickerThanTheSectionIsWide) {
  const std::vector<Point2> flat{{0, 0}, {100, 0}, {100, 2}, {0, 2}};  // its radius is 32
  const double thin[] = {0.9};
  const double thick[] = {1.5};

  EXPECT_LT(wallSection(flat, thin).area, 200.0);
  EXPECT_THROW(static_cast<void>(wallSection(flat, thick)), Error);
}

TEST(WallSection, NamesTheThickestWallThatItTakes) {
  const std::vector<Point2> outline = outlineOf(shapes()[0].curve);
  const double below[] = {0.367};
  const double above[] = {0.368};

  EXPECT_GT(wallSection(outline, below).torsionConstant, 0.0);
  const Error error = testing::refusal([&] { return wallSection(outline, above); });
  EXPECT_NE(error.remedy().find("0.367 here"), std::string::npos) << error.remedy();
}

TEST(WallSection, TakesPointsThatRepeatAsTheSolverDoes) {
  const std::vector<Point2> square{{0, 0}, {0, 0}, {10, 0}, {10, 10}, {10, 10}, {0, 10}};
  const std::vector<Point2> once{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const double each[] = {1.0, 9.0, 1.1, 1.2, 9.0, 1.3};
  const double four[] = {1.0, 1.1, 1.2, 1.3};

  EXPECT_EQ(wallSection(square, each).torsionConstant, wallSection(once, four).torsionConstant);
}

}  // namespace
}  // namespace torsio
