// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every section, whatever its shape.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/tissue/section/section_solver.h"
#include "tests/sim/tissue/section_shapes.h"

namespace torsio {
namespace {

constexpr double kBracket = 2e-4;  // SectionSolverOptions::bracket

void expectBracket(const SectionProperties& section, const char* what, int number) {
  EXPECT_LE(section.torsionLower, section.torsionUpper * (1.0 + 1e-12)) << what << ' ' << number;
  EXPECT_LE(section.torsionUpper - section.torsionLower, kBracket * section.torsionConstant)
      << what << ' ' << number;
  // Saint-Venant: the circle is the stiffest section of its area, and no section is stiffer than Ip.
  EXPECT_LE(section.torsionUpper, section.polarMoment * (1.0 + 1e-12)) << what << ' ' << number;
  EXPECT_LE(section.torsionLower, section.area * section.area / (2.0 * kPi)) << what << ' ' << number;
  EXPECT_EQ(section.methodUsed, SectionMethod::kFiniteElements);
}

SectionProperties byBoundaryElements(const shapes::Outline& outline, int points,
                                     const std::vector<shapes::Outline>& holes = {}) {
  return solveSection(outline, {.method = SectionMethod::kBoundaryElements, .outlinePoints = points}, holes);
}

TEST(SectionBracket, HoldsOnRandomStarShapedPolygons) {
  Random random(11);
  SectionSolver solver;
  for (int k = 0; k < 12; ++k) {
    const shapes::Outline outline = shapes::randomStar(random, 5 + k);

    const SectionProperties section = solver.solve(outline);

    expectBracket(section, "star", k);
    // Spikes and notches are the worst for constant fluxes: 2 % on 256 points.
    EXPECT_NEAR(byBoundaryElements(outline, 128).torsionConstant / section.torsionConstant, 1.0, 0.02)
        << "star " << k;
  }
}

TEST(SectionBracket, HoldsOnRandomPolygonsThatAreNotStarShaped) {
  Random random(12);
  SectionSolver solver;
  for (int k = 0; k < 12; ++k) {
    const shapes::Outline outline = shapes::randomSimple(random, 6 + k, k % 2 == 0 ? 1.0 : 0.3);

    const SectionProperties section = solver.solve(outline);

    expectBracket(section, "polygon", k);
    EXPECT_NEAR(byBoundaryElements(outline, 128).torsionConstant / section.torsionConstant, 1.0, 0.02)
        << "polygon " << k;
  }
}

TEST(SectionBracket, ClosesUnderRefinementAroundTheSameValue) {
  const shapes::Outline outline = shapes::organ(96);

  const SectionProperties coarse = solveSection(outline, {.rings = 3, .bracket = 1.0});
  const SectionProperties usual = solveSection(outline);
  const SectionProperties fine = solveSection(outline, {.bracket = 1e-6});

  EXPECT_LT(fine.torsionUpper - fine.torsionLower, 1e-6 * fine.torsionConstant);
  for (const SectionProperties& wider : {coarse, usual}) {
    EXPECT_LE(wider.torsionLower, fine.torsionUpper);
    EXPECT_GE(wider.torsionUpper, fine.torsionLower);
  }
}

TEST(SectionBracket, SurvivesPointsThatRepeatAndPointsOnAStraightLine) {
  const shapes::Outline plain = shapes::rectangle(2.0, 1.0);
  const shapes::Outline crowded = {{-1, -0.5}, {-1, -0.5}, {0.3, -0.5}, {1, -0.5}, {1, 0.1},
                                   {1, 0.5},   {1, 0.5},   {-1, 0.5},   {-1, -0.5}};

  const SectionProperties a = solveSection(plain), b = solveSection(crowded);

  EXPECT_NEAR(a.torsionConstant, b.torsionConstant, kBracket * a.torsionConstant);
  ASSERT_EQ(b.outlineWarping.size(), crowded.size());
  EXPECT_EQ(b.outlineWarping[0], b.outlineWarping[1]);
  EXPECT_EQ(b.outlineWarping[0], b.outlineWarping[8]);
}

TEST(SectionBracket, HoldsOnThinTubesWhosePointsFaceEachOther) {
  for (const double thickness : {0.1, 0.02, 0.01, 1e-3, 1e-5}) {
    const std::vector<shapes::Outline> hole = {shapes::rectangle(1.0, 1.0)};

    const SectionProperties tube =
        solveSection(shapes::rectangle(1.0 + 2 * thickness, 1.0 + 2 * thickness), {}, hole);

    EXPECT_EQ(tube.methodUsed, SectionMethod::kFiniteElements);
    EXPECT_LE(tube.torsionLower, tube.torsionUpper);
    EXPECT_LE(tube.torsionUpper - tube.torsionLower, kBracket * tube.torsionConstant) << thickness;
    // Bredt: 4 Am^2 t / perimeter with the middle line of side 1 + t; the corners add terms of order t.
    const double side = 1.0 + thickness;
    EXPECT_NEAR(tube.torsionConstant / (thickness * side * side * side), 1.0, 2.0 * thickness + 2e-4)
        << thickness;
  }
}

TEST(SectionBracket, HoldsOnRandomSectionsWithHoles) {
  Random random(13);
  for (int k = 0; k < 10; ++k) {
    std::vector<shapes::Outline> holes;
    for (int i = 0; i < 1 + k % 3; ++i) {
      const double angle = 2.0 * kPi * (i + 0.3 * random.uniform()) / 3.0,
                   way = 0.35 + 0.2 * random.uniform();
      holes.push_back(shapes::moved(shapes::randomStar(random, 4 + k), 0.08 + 0.1 * random.uniform(),
                                    {way * std::cos(angle), way * std::sin(angle)}));
    }

    const SectionProperties section = solveSection(shapes::organ(90 + k), {}, holes);

    EXPECT_EQ(section.methodUsed, SectionMethod::kFiniteElements);
    EXPECT_LE(section.torsionLower, section.torsionUpper);
    EXPECT_LE(section.torsionUpper - section.torsionLower, kBracket * section.torsionConstant) << k;
    EXPECT_LE(section.torsionUpper, section.polarMoment) << k;
    EXPECT_NEAR(
        byBoundaryElements(shapes::organ(90 + k), 128, holes).torsionConstant / section.torsionConstant, 1.0,
        5e-3)
        << k;
  }
}

TEST(SectionSolver, FallsBackToBoundaryElementsWhereEdgesAllButTouch) {
  const double gap = 1e-9;
  const shapes::Outline slit = {{-1, -1}, {1, -1}, {1, 1}, {gap, 1}, {gap, 0}, {-gap, 0}, {-gap, 1}, {-1, 1}};

  const SectionProperties section = solveSection(slit);

  EXPECT_EQ(section.methodUsed, SectionMethod::kBoundaryElements);
  // As with a slit of 1e-4, which finite elements can do.
  EXPECT_NEAR(section.torsionConstant, 1.2972, 0.01);
  EXPECT_THROW(static_cast<void>(solveSection(slit, {.method = SectionMethod::kFiniteElements})), Error);
}

TEST(SectionField, HoldsAWarpingWhoseMeanIsZero) {
  SectionField field;
  const SectionProperties section =
      SectionSolver().solve(shapes::moved(shapes::organ(128), 0.03, {0.2, 0.1}), {}, &field);

  double sum = 0.0, area = 0.0;
  for (const auto& e : field.elements) {
    const auto node = [&](std::size_t k) { return field.nodes[static_cast<std::size_t>(e[k])]; };
    const double part = 0.5 * orientation(node(0), node(1), node(2));
    area += part;
    for (std::size_t k = 3; k < 6; ++k) {
      sum += part / 3.0 * field.warping[static_cast<std::size_t>(e[k])];
    }
  }

  EXPECT_NEAR(area / section.area, 1.0, 1e-12);
  EXPECT_NEAR(sum / (section.area * section.warpingMax), 0.0, 1e-12);
}

TEST(SectionSolver, GivesTheSameResultWhateverWasSolvedBefore) {
  SectionSolver solver;
  const SectionProperties first = solver.solve(shapes::organ(128));
  static_cast<void>(solver.solve(shapes::kidney(100)));
  static_cast<void>(solver.solve(shapes::circle(128)));

  const SectionProperties again = solver.solve(shapes::organ(128));

  EXPECT_EQ(first.torsionConstant, again.torsionConstant);
  EXPECT_EQ(first.outlineWarping, again.outlineWarping);
  EXPECT_EQ(first.outlineShear, again.outlineShear);
}

TEST(SectionSolver, ScalesWithTheFourthPowerOfLengthAnywhereInThePlane) {
  constexpr double kRounding = 1e-10;  // the shift costs the outline its last digits
  const shapes::Outline outline = shapes::organ(128);
  const double scale = 0.03;  // metres
  const SectionProperties unit = solveSection(outline);

  const SectionProperties small = solveSection(shapes::moved(outline, scale, {0.4, -0.7}));

  EXPECT_NEAR(small.area / unit.area / std::pow(scale, 2), 1.0, kRounding);
  EXPECT_NEAR(small.torsionConstant / unit.torsionConstant / std::pow(scale, 4), 1.0, kRounding);
  EXPECT_NEAR(small.torsionLower / unit.torsionLower / std::pow(scale, 4), 1.0, kRounding);
  EXPECT_NEAR(small.polarMoment / unit.polarMoment / std::pow(scale, 4), 1.0, kRounding);
  EXPECT_NEAR(small.volume / unit.volume / std::pow(scale, 4), 1.0, kRounding);
  EXPECT_NEAR(small.sag / unit.sag / std::pow(scale, 2), 1.0, kRounding);
  EXPECT_NEAR(small.warpingMax / unit.warpingMax / std::pow(scale, 2), 1.0, kRounding);
  EXPECT_NEAR(small.maxShear / unit.maxShear / scale, 1.0, kRounding);
  EXPECT_NEAR(small.centroid[0], 0.4 + scale * unit.centroid[0], 1e-14);
  EXPECT_NEAR(small.shearCentre[1], -0.7 + scale * unit.shearCentre[1], 1e-12);
}

TEST(SectionSolver, GivesAMirroredSectionTheMirroredWarping) {
  // Diagonals of the mesh do not mirror: differences of the size of the element error remain.
  constexpr double kMesh = 2e-4;
  constexpr double kShearMesh = 8e-3;  // of values up to 1.6
  const shapes::Outline outline = shapes::organ(128);
  const SectionProperties section = solveSection(outline);

  const SectionProperties mirror = solveSection(shapes::mirrored(outline));

  EXPECT_NEAR(mirror.torsionConstant / section.torsionConstant, 1.0, kBracket);
  EXPECT_NEAR(mirror.centroid[0], -section.centroid[0], 1e-14);
  EXPECT_NEAR(mirror.shearCentre[0], -section.shearCentre[0], kMesh);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    EXPECT_NEAR(mirror.outlineWarping[i], -section.outlineWarping[i], kMesh);
    EXPECT_NEAR(mirror.outlineShear[i], section.outlineShear[i], kShearMesh);
  }
}

TEST(SectionSolver, DoesNotMindTheDirectionOrTheStartOfTheOutline) {
  const shapes::Outline outline = shapes::organ(128);
  shapes::Outline backwards(outline.rbegin(), outline.rend());
  std::rotate(backwards.begin(), backwards.begin() + 37, backwards.end());

  const SectionProperties a = solveSection(outline), b = solveSection(backwards);

  EXPECT_NEAR(b.torsionConstant / a.torsionConstant, 1.0, kBracket);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto place = std::find(backwards.begin(), backwards.end(), outline[i]) - backwards.begin();
    EXPECT_NEAR(b.outlineWarping[static_cast<std::size_t>(place)], a.outlineWarping[i], 2e-4);
  }
}

TEST(SectionSolver, BalancesTheStressOnTheOutline) {
  // lap z = -1: the mean of tau = 2 |dz/dn| over the outline is 2 area / length, whatever the shape.
  for (const shapes::Outline& outline : {shapes::circle(64), shapes::organ(128), shapes::kidney(200)}) {
    const SectionProperties section = solveSection(outline);
    double sum = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point2& before = outline[(i + outline.size() - 1) % outline.size()];
      const Point2& after = outline[(i + 1) % outline.size()];
      sum += section.outlineShear[i] * 0.5 *
             (std::hypot(outline[i][0] - before[0], outline[i][1] - before[1]) +
              std::hypot(after[0] - outline[i][0], after[1] - outline[i][1]));
    }
    EXPECT_NEAR(sum / (2.0 * section.area), 1.0, 2e-3);
  }
}

TEST(BoundaryElements, AgreeWithFiniteElementsOnSmoothOutlines) {
  constexpr double kCrossCheck = 1e-3;
  for (const shapes::Outline& outline :
       {shapes::circle(128), shapes::ellipse(128, 2.0, 1.0), shapes::organ(128), shapes::organ(100)}) {
    const SectionProperties elements = solveSection(outline);

    const SectionProperties boundary = byBoundaryElements(outline, 128);

    EXPECT_NEAR(boundary.torsionConstant / elements.torsionConstant, 1.0, kCrossCheck);
    EXPECT_NEAR(boundary.sag / elements.sag, 1.0, kCrossCheck);
    EXPECT_NEAR(boundary.maxShear / elements.maxShear, 1.0, 5.0 * kCrossCheck);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      EXPECT_NEAR(boundary.outlineWarping[i], elements.outlineWarping[i], kCrossCheck);
    }
  }
}

TEST(BoundaryElements, AgreeWithFiniteElementsOnAKidneyShapedSection) {
  const shapes::Outline outline = shapes::kidney(256);
  const SectionProperties reference = solveSection(outline, {.bracket = 2e-5});

  const SectionProperties boundary = byBoundaryElements(outline, 256);

  EXPECT_NEAR(boundary.torsionConstant / reference.torsionConstant, 1.0, 1e-3);
  EXPECT_NEAR(boundary.sag / reference.sag, 1.0, 1e-3);
  EXPECT_NEAR(boundary.warpingMax / reference.warpingMax, 1.0, 1e-3);
  EXPECT_NEAR(boundary.warpingMin / reference.warpingMin, 1.0, 1e-3);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    EXPECT_NEAR(boundary.outlineWarping[i], reference.outlineWarping[i], 2e-3);
  }
  // The change under refinement is reported as the (not rigorous) bracket.
  EXPECT_LT(boundary.torsionLower, boundary.torsionUpper);
  EXPECT_EQ(boundary.methodUsed, SectionMethod::kBoundaryElements);
}

TEST(BoundaryElements, ConvergeOnAPolygonThatIsNotStarShaped) {
  const shapes::Outline shape = {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};  // a U
  const SectionProperties reference = solveSection(shape, {.bracket = 1e-5});

  const double coarse = byBoundaryElements(shape, 64).torsionConstant / reference.torsionConstant - 1.0;
  const double fine = byBoundaryElements(shape, 256).torsionConstant / reference.torsionConstant - 1.0;

  EXPECT_LT(std::abs(fine), 2e-3);
  EXPECT_LT(std::abs(fine), 0.4 * std::abs(coarse));
}

TEST(BoundaryElements, AgreeWithFiniteElementsOnSectionsWithHoles) {
  const shapes::Outline outline = shapes::circle(128);
  constexpr double kShearOnCoarseHoles = 0.03;  // constant fluxes on 48 edges; the largest stress is 1.6
  const std::vector<std::vector<shapes::Outline>> cases = {
      {shapes::circle(128, 0.5)},
      {shapes::circle(64, 0.3, {0.5, 0.0})},
      {shapes::circle(48, 0.2, {0.5, 0.0}), shapes::circle(48, 0.2, {-0.4, 0.3})}};
  for (const auto& holes : cases) {
    const SectionProperties elements = solveSection(outline, {}, holes);

    const SectionProperties boundary = byBoundaryElements(outline, 128, holes);

    EXPECT_NEAR(boundary.torsionConstant / elements.torsionConstant, 1.0, 1e-3);
    EXPECT_NEAR(boundary.sag / elements.sag, 1.0, 1e-3);
    ASSERT_EQ(boundary.holeWarping.size(), holes.size());
    for (std::size_t k = 0; k < holes.size(); ++k) {
      for (std::size_t i = 0; i < holes[k].size(); ++i) {
        EXPECT_NEAR(boundary.holeWarping[k][i], elements.holeWarping[k][i], 1e-3);
        EXPECT_NEAR(boundary.holeShear[k][i], elements.holeShear[k][i], kShearOnCoarseHoles);
      }
    }
  }
}

TEST(SectionSolver, SplitsWhereAnIncisuraCutsIn) {
  // A deep smooth notch, as at the incisura of the stomach.
  shapes::Outline outline;
  for (int i = 0; i < 160; ++i) {
    const double t = 2.0 * kPi * i / 160;
    const double r = 1.0 - 0.75 * std::exp(-std::pow((t - kPi) / 0.25, 2));
    outline.push_back({r * std::cos(t), r * std::sin(t)});
  }

  const SectionProperties section = solveSection(outline);

  expectBracket(section, "notch", 0);
  // The bottom of the notch carries the largest stress.
  EXPECT_EQ(std::max_element(section.outlineShear.begin(), section.outlineShear.end()) -
                section.outlineShear.begin(),
            80);
}

}  // namespace
}  // namespace torsio
