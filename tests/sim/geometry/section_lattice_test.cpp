// SPDX-License-Identifier: GPL-3.0-or-later
// Straight bars, whose lattice is known in closed form.

#include "sim/geometry/lattice/section_lattice.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/refusal.h"

namespace torsio {

namespace {

using testing::areaOf;
using testing::centroidOf;
using testing::Outline2;

constexpr double kHeight_m = 0.2;
/// Rounding of coordinates of 0.2 m, with a reserve of a thousand.
constexpr double kExact_m = 1e-13;
/// Asked of bars in every mode: a micrometre's thousandth.
constexpr double kBar_m = 1e-9;
/// A tapered square is no surface of revolution: the levels of the harmonic field bow in its faces, and its
/// clamped weights lean with the diagonals of the mesh. The planes of the straight axis know nothing of that.
constexpr double kBowed_m = 2e-5;
constexpr double kBowedArc_m = 3e-4;
constexpr double kBowedRidge_m = 3e-3;
constexpr double kBowedArea = 2e-3;  // relative

struct Bar {
  std::string name;
  Outline2 outline;
  double topScale = 1.0;
};

std::vector<Bar> bars() {
  return {{"circle", testing::circleOutline(0.03, 72), 1.0},
          {"ellipse", testing::ellipseOutline(0.04, 0.02, 72), 1.0},
          {"square", testing::rectangleOutline(0.04, 0.04, 9), 1.0},
          {"tapered circle", testing::circleOutline(0.04, 72), 0.5},
          {"tapered square", testing::rectangleOutline(0.05, 0.05, 10), 0.6},
          {"star", testing::starOutline(5, 0.04, 0.02), 1.0},
          {"letter C", testing::letterC(0.03, 0.012, 24), 1.0}};
}

double distanceFrom(const Outline2& outline, const Point2& p) {
  double least = 1e9;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& a = outline[i];
    const auto& b = outline[(i + 1) % outline.size()];
    const double dx = b[0] - a[0];
    const double dy = b[1] - a[1];
    const double t = std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    least = std::min(least, std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy));
  }
  return least;
}

Outline2 outlineOf(const SectionLattice& lattice, int j) {
  return {lattice.outline_m(j).begin(), lattice.outline_m(j).end()};
}

/// The outline of section j in world coordinates, seen along z.
Outline2 seenFromAbove(const SectionLattice& lattice, int j) {
  const AxisFrame frame = lattice.frameAt(lattice.sectionArc_m(j));
  Outline2 seen;
  for (const Point2& p : lattice.outline_m(j)) {
    const Vec3 q = frame.centre_m + p[0] * frame.e1 + p[1] * frame.e2;
    seen.push_back({q.x, q.y});
  }
  return seen;
}

class StraightBar : public ::testing::TestWithParam<LatticeMode> {
 protected:
  static bool bowed(const Bar& bar) {
    return GetParam() == LatticeMode::kHarmonic && bar.name == "tapered square";
  }
  static LatticeOptions options() { return {.ridges = 24, .sections = 17, .mode = GetParam()}; }
};

TEST_P(StraightBar, HasItsExactLengthAndParallelFrames) {
  for (const Bar& bar : bars()) {
    const TriangleMesh mesh = testing::prism(bar.outline, kHeight_m, 40, bar.topScale);

    const SectionLattice lattice(mesh, options());

    EXPECT_NEAR(lattice.length_m(), kHeight_m, kExact_m) << bar.name;
    const AxisFrame first = lattice.frameAt(0.0);
    EXPECT_NEAR(first.centre_m.z, 0.0, kExact_m) << bar.name;
    EXPECT_NEAR(norm(first.tangent - Vec3{0, 0, 1}), 0.0, kExact_m) << bar.name;
    for (int j = 0; j < lattice.sections(); ++j) {
      const double arc = lattice.sectionArc_m(j);
      const AxisFrame frame = lattice.frameAt(arc);
      EXPECT_DOUBLE_EQ(arc, lattice.length_m() * j / (lattice.sections() - 1));
      EXPECT_NEAR(frame.centre_m.z, arc, kExact_m) << bar.name << " " << j;
      EXPECT_LT(norm(frame.e1 - first.e1), kExact_m) << bar.name << " " << j;
      EXPECT_LT(norm(frame.e2 - first.e2), kExact_m) << bar.name << " " << j;
    }
  }
}

TEST_P(StraightBar, HasTheTrueOutlineInEverySection) {
  for (const Bar& bar : bars()) {
    const TriangleMesh mesh = testing::prism(bar.outline, kHeight_m, 40, bar.topScale);

    const SectionLattice lattice(mesh, options());

    for (int j = 0; j < lattice.sections(); ++j) {
      const double scale = 1.0 + (bar.topScale - 1.0) * lattice.sectionArc_m(j) / kHeight_m;
      Outline2 truth = bar.outline;
      for (auto& p : truth) {
        p = {scale * p[0], scale * p[1]};
      }
      for (const Point2& p : seenFromAbove(lattice, j)) {
        EXPECT_LT(distanceFrom(truth, p), bowed(bar) ? kBowed_m : kBar_m) << bar.name << " " << j;
      }
      const double tolerance = (bowed(bar) ? kBowedArea : 1e-9) * areaOf(truth);
      EXPECT_NEAR(areaOf(outlineOf(lattice, j)), areaOf(truth), tolerance) << bar.name << " " << j;
    }
  }
}

TEST_P(StraightBar, PutsTheCentreOnTheCentroid) {
  for (const Bar& bar : bars()) {
    const TriangleMesh mesh = testing::prism(bar.outline, kHeight_m, 40, bar.topScale);
    const auto truth = centroidOf(bar.outline);

    const SectionLattice lattice(mesh, options());

    for (int j = 0; j < lattice.sections(); ++j) {
      const auto off = centroidOf(outlineOf(lattice, j));
      EXPECT_LT(std::hypot(off[0], off[1]), kBar_m) << bar.name << " " << j;
      const double scale = 1.0 + (bar.topScale - 1.0) * lattice.sectionArc_m(j) / kHeight_m;
      const Vec3 centre = lattice.frameAt(lattice.sectionArc_m(j)).centre_m;
      EXPECT_NEAR(centre.x, scale * truth[0], kBar_m) << bar.name << " " << j;
      EXPECT_NEAR(centre.y, scale * truth[1], kBar_m) << bar.name << " " << j;
    }
  }
}

TEST_P(StraightBar, LiesAnywhereInSpace) {
  const TriangleMesh upright = testing::prism(testing::starOutline(5, 0.04, 0.02), kHeight_m, 20);
  // Turned by less than a right angle, so that the same end stays the lower one.
  const TriangleMesh mesh =
      testing::shifted(testing::turned(upright, {0.3, 1.0, 0.2}, 1.1), {0.1, -0.4, 2.0});

  const SectionLattice lattice(mesh, options());

  EXPECT_NEAR(lattice.length_m(), kHeight_m, 1e-12);
  const double area = areaOf(testing::starOutline(5, 0.04, 0.02));
  for (int j = 0; j < lattice.sections(); ++j) {
    EXPECT_NEAR(areaOf(outlineOf(lattice, j)), area, 1e-9 * area);
  }
}

TEST_P(StraightBar, WorksWithNoVertexBetweenItsEnds) {
  const TriangleMesh mesh = testing::prism(testing::rectangleOutline(0.04, 0.03, 1), kHeight_m, 1);
  ASSERT_EQ(mesh.vertices_m.size(), 8U);

  const SectionLattice lattice(mesh, options());

  EXPECT_NEAR(lattice.length_m(), kHeight_m, kExact_m);
  for (int j = 0; j < lattice.sections(); ++j) {
    EXPECT_NEAR(areaOf(outlineOf(lattice, j)), 0.04 * 0.03, 1e-12);
  }
}

TEST_P(StraightBar, LeadsEachRidgeStraightFromEndToEnd) {
  // Angle of the harmonic field on a flat wall: linear up to the smallest weight (1e-6).
  constexpr double kRidge_m = 1e-6;
  for (const Bar& bar : bars()) {
    const TriangleMesh mesh = testing::prism(bar.outline, kHeight_m, 40, bar.topScale);

    const SectionLattice lattice(mesh, options());

    for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
      const Vec3 foot = lattice.keyPoint_m(ridge, 0);
      for (int j = 0; j < lattice.sections(); ++j) {
        const Vec3 p = lattice.keyPoint_m(ridge, j);
        const double scale = 1.0 + (bar.topScale - 1.0) * lattice.sectionArc_m(j) / kHeight_m;
        EXPECT_NEAR(p.z, lattice.sectionArc_m(j), bowed(bar) ? kBowedArc_m : kExact_m) << bar.name;
        const double tolerance = bowed(bar) ? kBowedRidge_m : kRidge_m;
        EXPECT_NEAR(p.x, scale * foot.x, tolerance) << bar.name << " " << ridge << " " << j;
        EXPECT_NEAR(p.y, scale * foot.y, tolerance) << bar.name << " " << ridge << " " << j;
      }
    }
  }
}

TEST_P(StraightBar, SpacesRidgesByEqualWayOrEqualAngle) {
  const TriangleMesh mesh = testing::prism(testing::rectangleOutline(0.06, 0.03, 6), kHeight_m, 20);
  LatticeOptions byWay = options();
  LatticeOptions byAngle = options();
  byWay.spacing = RidgeSpacing::kArcLength;
  byAngle.spacing = RidgeSpacing::kAngle;
  byWay.ridgeZero = byAngle.ridgeZero = {1, 0, 0};

  const SectionLattice ways(mesh, byWay);
  const SectionLattice angles(mesh, byAngle);

  EXPECT_EQ(ways.spacing(), RidgeSpacing::kArcLength);
  EXPECT_EQ(angles.spacing(), RidgeSpacing::kAngle);
  // Perimeter 0.18 m, 24 ridges: 7.5 mm each. Ridge 1 is that far up the side x = 30 mm.
  EXPECT_NEAR(ways.keyPoint_m(0, 8).y, 0.0, 1e-7);
  EXPECT_NEAR(ways.keyPoint_m(1, 8).x, 0.03, 1e-9);
  EXPECT_NEAR(ways.keyPoint_m(1, 8).y, 0.0075, 1e-7);
  for (int ridge = 0; ridge < 24; ++ridge) {
    const Vec3 p = angles.keyPoint_m(ridge, 8);
    double angle = std::atan2(p.y, p.x);
    if (angle < -1e-9) {
      angle += 2.0 * kPi;
    }
    EXPECT_NEAR(angle, 2.0 * kPi * ridge / 24, 1e-9);
  }
}

TEST_P(StraightBar, DividesAnOutlineAsPromised) {
  const TriangleMesh mesh = testing::prism(testing::letterC(0.03, 0.012, 24), kHeight_m, 20);

  const SectionLattice lattice(mesh, options());

  for (int j = 0; j < lattice.sections(); ++j) {
    const auto outline = lattice.outline_m(j);
    const auto angles = lattice.outlineAngles_rad(j);
    const AxisFrame frame = lattice.frameAt(lattice.sectionArc_m(j));
    ASSERT_EQ(outline.size(), angles.size());
    EXPECT_GE(outline.size(), static_cast<std::size_t>(kMinOutlinePoints));
    EXPECT_EQ(angles.front(), 0.0);
    EXPECT_TRUE(std::is_sorted(angles.begin(), angles.end(), [](double a, double b) { return a <= b; }));
    EXPECT_LT(angles.back(), 2.0 * kPi);
    for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
      const double angle = 2.0 * kPi * ridge / lattice.ridges();
      const auto at = std::lower_bound(angles.begin(), angles.end(), angle - 1e-12);
      ASSERT_NE(at, angles.end());
      EXPECT_NEAR(*at, angle, 1e-12);
      const Point2& p = outline[static_cast<std::size_t>(at - angles.begin())];
      const Vec3 d = lattice.keyPoint_m(ridge, j) - frame.centre_m;
      EXPECT_NEAR(p[0], dot(d, frame.e1), kBar_m);
      EXPECT_NEAR(p[1], dot(d, frame.e2), kBar_m);
    }
  }
}

TEST_P(StraightBar, FindsEachVertexAgainByItsCoordinates) {
  // The way along an outline is tabulated at 256 angles and a few hundred levels; between them it is linear.
  constexpr double kTable_m = 2e-5;
  for (const Bar& bar : bars()) {
    for (const RidgeSpacing spacing : {RidgeSpacing::kArcLength, RidgeSpacing::kAngle}) {
      const TriangleMesh mesh = testing::prism(bar.outline, kHeight_m, 40, bar.topScale);
      LatticeOptions asked = options();
      asked.spacing = spacing;

      const SectionLattice lattice(mesh, asked);

      ASSERT_EQ(lattice.vertexCoordinates().size(), mesh.vertices_m.size());
      const double tolerance = lattice.spacing() == RidgeSpacing::kAngle ? kBar_m : kTable_m;
      for (std::size_t v = 0; v < mesh.vertices_m.size(); v += 13) {
        const LatticeCoordinate c = lattice.vertexCoordinates()[v];
        const double arcTolerance = bowed(bar) ? kBowedArc_m : kExact_m;
        EXPECT_NEAR(c.arc_m, mesh.vertices_m[v].z, arcTolerance) << bar.name << " " << v;
        EXPECT_GE(c.angle_rad, 0.0);
        EXPECT_LT(c.angle_rad, 2.0 * kPi);
        if (lattice.vertexParts()[v] != LatticePart::kSide) {
          continue;
        }
        const LatticePoint p = lattice.surfacePoint(c);
        EXPECT_LT(norm(p.position_m - mesh.vertices_m[v]), tolerance) << bar.name << " " << v;
        Vec3 blended;
        for (std::size_t k = 0; k < 3; ++k) {
          blended += p.barycentric[k] * mesh.vertices_m[mesh.triangles[p.triangle][k]];
        }
        EXPECT_LT(norm(blended - p.position_m), kBar_m) << bar.name << " " << v;
      }
    }
  }
}

TEST_P(StraightBar, MapsItsAxisBackToItself) {
  const TriangleMesh mesh = testing::prism(testing::ellipseOutline(0.04, 0.02, 48), kHeight_m, 20, 0.7);

  const SectionLattice lattice(mesh, options());

  for (int k = 0; k <= 100; ++k) {
    const double arc = lattice.length_m() * k / 100;
    const AxisFrame frame = lattice.frameAt(arc);
    EXPECT_NEAR(norm(frame.e1), 1.0, 1e-15);
    EXPECT_NEAR(norm(cross(frame.e1, frame.e2) - frame.tangent), 0.0, 1e-15);
    EXPECT_NEAR(lattice.nearestArc_m(frame.centre_m + 0.03 * frame.e1 - 0.01 * frame.e2), arc, 1e-12);
  }
  EXPECT_EQ(lattice.nearestArc_m({0, 0, -1}), 0.0);
  EXPECT_EQ(lattice.nearestArc_m({0, 0, 1}), lattice.length_m());
}

TEST_P(StraightBar, StaysTheSameHoweverItIsTriangulated) {
  // Diagonals that change sides, as after remeshing: the field is no longer linear to the last digit.
  constexpr double kRemeshed_m = 2e-5;
  const Outline2 outline = testing::ellipseOutline(0.04, 0.025, 60);
  const TriangleMesh mesh = testing::sweep(
      outline, 30,
      [](double t) {
        const double z = kHeight_m * (t + 0.02 * std::sin(2.0 * kPi * t));
        return testing::SweepFrame{{0, 0, z}, {1, 0, 0}, {0, 1, 0}, 1.0};
      },
      true);

  const SectionLattice lattice(mesh, options());

  EXPECT_NEAR(lattice.length_m(), kHeight_m, 1e-9);
  for (int j = 0; j < lattice.sections(); ++j) {
    EXPECT_NEAR(areaOf(outlineOf(lattice, j)), areaOf(outline), 1e-4 * areaOf(outline));
    for (const Point2& p : seenFromAbove(lattice, j)) {
      EXPECT_LT(distanceFrom(outline, p), kRemeshed_m);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BothModes, StraightBar,
                         ::testing::Values(LatticeMode::kHarmonic, LatticeMode::kStraightAxis),
                         [](const auto& mode) {
                           return mode.param == LatticeMode::kHarmonic ? "Harmonic" : "StraightAxis";
                         });

TEST(SectionLattice, CountsPatchesAsInEquation13) {
  const TriangleMesh mesh = testing::prism(testing::circleOutline(0.03, 24), kHeight_m, 10);

  const SectionLattice lattice(mesh, LatticeOptions{.ridges = 7, .sections = 5});

  EXPECT_EQ(lattice.patches(), 28);  // (5 - 1) 7
  EXPECT_EQ(lattice.ridges(), 7);
  EXPECT_EQ(lattice.sections(), 5);
}

TEST(SectionLattice, CountsSectionsFromTheClampToTheFreeEnd) {
  const TriangleMesh mesh = testing::prism(testing::circleOutline(0.03, 24), kHeight_m, 10);

  const SectionLattice lattice(mesh, LatticeOptions{.ridges = 12, .sections = 9});

  EXPECT_NEAR(lattice.keyPoint_m(6, 0).z, 0.0, kExact_m);
  EXPECT_NEAR(lattice.keyPoint_m(0, 8).z, kHeight_m, kExact_m);
}

TEST(SectionLattice, TakesTheSmallestAndTheLargestCounts) {
  const TriangleMesh mesh = testing::prism(testing::ellipseOutline(0.04, 0.02, 48), kHeight_m, 20);
  for (const int ridges : {kMinRidges, kMaxRidges}) {
    for (const int sections : {kMinSections, kMaxSections}) {
      const SectionLattice lattice(mesh, LatticeOptions{.ridges = ridges, .sections = sections});

      EXPECT_EQ(lattice.patches(), (sections - 1) * ridges);
      EXPECT_NEAR(lattice.keyPoint_m(ridges - 1, sections - 1).z, kHeight_m, kExact_m);
      EXPECT_NEAR(lattice.keyPoint_m(0, 0).z, 0.0, kExact_m);
    }
  }
}

TEST(SectionLattice, FallsBackToEqualWayForTheWholeOrganWhenASectionIsNotStarShaped) {
  const TriangleMesh mesh = testing::prism(testing::letterC(0.03, 0.012, 24), kHeight_m, 20);
  LatticeOptions options{.spacing = RidgeSpacing::kAngle};
  for (const LatticeMode mode : {LatticeMode::kHarmonic, LatticeMode::kStraightAxis}) {
    options.mode = mode;

    const SectionLattice lattice(mesh, options);

    EXPECT_EQ(lattice.options().spacing, RidgeSpacing::kAngle);
    EXPECT_EQ(lattice.spacing(), RidgeSpacing::kArcLength);
  }
}

TEST(SectionLattice, TurnsMirroredWhenTheOrganIsMirrored) {
  const TriangleMesh mesh = testing::prism(testing::letterC(0.03, 0.012, 24), kHeight_m, 20, 0.8);
  LatticeOptions options{.ridgeZero = {0, 1, 0}};

  const SectionLattice right(mesh, options);
  const SectionLattice left(testing::mirroredX(mesh), options);

  for (int j = 0; j < right.sections(); j += 6) {
    for (int ridge = 0; ridge < right.ridges(); ++ridge) {
      const Vec3 p = right.keyPoint_m(ridge, j);
      const Vec3 q = left.keyPoint_m((right.ridges() - ridge) % right.ridges(), j);
      EXPECT_LT(norm(Vec3{-p.x, p.y, p.z} - q), 1e-7) << ridge << " " << j;
    }
  }
}

TEST(SectionLattice, CutsAnOrganBetweenTheGivenPlanes) {
  // The upper half of the bar is to follow the last section, as a hand follows the wrist.
  const TriangleMesh mesh = testing::prism(testing::circleOutline(0.03, 48), kHeight_m, 40);
  LatticeOptions options{
      .mode = LatticeMode::kStraightAxis, .fixedEnd_m = {0.001, 0, 0}, .freeEnd_m = {0, 0.002, 0.1}};

  const SectionLattice lattice(mesh, options);

  // The axis is that of the flat end, the planes end at the height of the free end point.
  EXPECT_NEAR(lattice.length_m(), 0.1, kExact_m);
  EXPECT_NEAR(lattice.frameAt(0.05).tangent.z, 1.0, 1e-12);
  for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
    if (mesh.vertices_m[v].z < 0.1001) {
      continue;
    }
    EXPECT_EQ(lattice.vertexParts()[v], LatticePart::kFreeCap);
    EXPECT_EQ(lattice.vertexCoordinates()[v].arc_m, lattice.length_m());
  }
}

TEST(SectionLattice, CutsACurvedOrganWhereAsked) {
  const TriangleMesh mesh = testing::prism(testing::circleOutline(0.03, 48), kHeight_m, 40);
  LatticeOptions options{.fixedEnd_m = {0, 0, 0}, .freeEnd_m = {0, 0, 0.1}, .freeCut = {0, 0, 1}};

  const SectionLattice lattice(mesh, options);

  // A cut through the mesh ends about an edge length before it: rings are 5 mm apart.
  EXPECT_NEAR(lattice.length_m(), 0.1, 0.006);
  for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
    if (mesh.vertices_m[v].z <= 0.1) {
      continue;
    }
    EXPECT_EQ(lattice.vertexParts()[v], LatticePart::kFreeCap);
  }
}

}  // namespace

namespace {

// What the lattice refuses, and that it says why.

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TriangleMesh bar() {
  return testing::prism(testing::circleOutline(0.03, 24), 0.2, 10);
}

Error refusal(const TriangleMesh& mesh, const LatticeOptions& options) {
  return testing::refusal([&] { const SectionLattice lattice(mesh, options); });
}

TEST(LatticeInput, RefusesTwoRidgesBecauseTheyBoundNoArea) {
  testing::expectError(refusal(bar(), LatticeOptions{.ridges = 2}), ErrorCode::kBadParameter,
                       {"2 ridges", "3 to 360", "cannot bound an area"});
}

TEST(LatticeInput, RefusesCountsOutOfRange) {
  for (const int ridges : {-1, 0, 361}) {
    testing::expectError(refusal(bar(), LatticeOptions{.ridges = ridges}), ErrorCode::kBadParameter,
                         {std::to_string(ridges) + " ridges"});
  }
  for (const int sections : {-1, 1, 361}) {
    testing::expectError(refusal(bar(), LatticeOptions{.sections = sections}), ErrorCode::kBadParameter,
                         {std::to_string(sections) + " sections", "2 to 360"});
  }
}

TEST(LatticeInput, RefusesNumbersThatAreNotFinite) {
  const auto change = std::vector<std::function<void(LatticeOptions&)>>{
      [](LatticeOptions& o) { o.fixedEnd_m.x = kNaN; },
      [](LatticeOptions& o) { o.freeEnd_m.z = std::numeric_limits<double>::infinity(); },
      [](LatticeOptions& o) {
        o.freeCut = {0, 0, kNaN};
      },
      [](LatticeOptions& o) {
        o.ridgeZero = {kNaN, 0, 0};
      },
      [](LatticeOptions& o) { o.ridgeZeroFraction = kNaN; },
      [](LatticeOptions& o) { o.ridgeZeroFraction = 1.5; },
      [](LatticeOptions& o) { o.capRadius_m = kNaN; },
      [](LatticeOptions& o) { o.capRadius_m = -0.01; }};
  for (std::size_t i = 0; i < change.size(); ++i) {
    LatticeOptions options;
    change[i](options);
    EXPECT_EQ(refusal(bar(), options).code(), ErrorCode::kBadParameter) << i;
  }
}

TEST(LatticeInput, RefusesAMeshThatIsNotClosedOrNotFinite) {
  TriangleMesh open = bar();
  open.triangles.pop_back();
  EXPECT_EQ(refusal(open, {}).code(), ErrorCode::kBadMesh);
  EXPECT_THAT(refusal(open, {}).what(), HasSubstr("open"));

  TriangleMesh broken = bar();
  broken.vertices_m[7].y = kNaN;
  EXPECT_EQ(refusal(broken, {}).code(), ErrorCode::kBadMesh);
  EXPECT_THAT(refusal(broken, {}).what(), HasSubstr("vertex 7"));

  TriangleMesh dangling = bar();
  dangling.triangles[3][1] = 100000;
  EXPECT_EQ(refusal(dangling, {}).code(), ErrorCode::kBadMesh);

  EXPECT_EQ(refusal(TriangleMesh{}, {}).code(), ErrorCode::kBadMesh);
}

TEST(LatticeInput, NamesTheFirstPlaneThatCutsTwoLoopsAndTheWayOut) {
  LatticeOptions options{.mode = LatticeMode::kStraightAxis};

  testing::expectError(refusal(testing::jTube(0.02, 0.12, 0.04, 32, 60), options), ErrorCode::kBadMesh,
                       {"section ", " of 25", "2 loops, exactly one is needed", "harmonic mode"});
}

TEST(LatticeInput, NamesAKinkWithItsTurnAndItsLimit) {
  constexpr double kTurn_rad = 2.6;  // 149 degrees

  testing::expectError(refusal(testing::kinkedTube(0.02, 0.1, kTurn_rad, 48, 40), {}), ErrorCode::kBadMesh,
                       {"kink", "degrees within one radius", "at most 90 degrees"});
}

TEST(LatticeInput, TakesABendThatIsNoKink) {
  const SectionLattice lattice(testing::kinkedTube(0.02, 0.1, 1.2, 48, 40), {});

  EXPECT_GT(lattice.length_m(), 0.17);
  EXPECT_LT(lattice.length_m(), 0.2);
}

TEST(LatticeInput, RefusesCapsThatTouch) {
  LatticeOptions options{.fixedEnd_m = {0, 0, -0.03}, .freeEnd_m = {0, 0, 0.18}, .capRadius_m = 0.2};

  testing::expectError(refusal(testing::capsule(0.03, 0.15, 24, 40), options), ErrorCode::kBadMesh,
                       {"caps of the organ touch"});
}

TEST(LatticeInput, RefusesACutBeyondTheOrgan) {
  testing::expectError(refusal(bar(), LatticeOptions{.freeEnd_m = {0, 0, 0.5}, .freeCut = {0, 0, 1}}),
                       ErrorCode::kBadParameter, {"free end", "nothing of the organ lies beyond"});
}

TEST(LatticeInput, RefusesACutWithoutEndPoints) {
  EXPECT_EQ(refusal(bar(), LatticeOptions{.freeCut = {0, 0, 1}}).code(), ErrorCode::kBadParameter);
}

TEST(LatticeInput, RefusesABallAlongItsPrincipalAxis) {
  LatticeOptions options{.mode = LatticeMode::kStraightAxis};

  testing::expectError(refusal(testing::capsule(0.05, 0.001, 32, 40), options), ErrorCode::kBadMesh,
                       {"no longest direction"});
}

TEST(LatticeInput, RefusesPlanesOutsideTheOrgan) {
  LatticeOptions options{
      .mode = LatticeMode::kStraightAxis, .fixedEnd_m = {0, 0, 0.5}, .freeEnd_m = {0, 0, 0.7}};

  EXPECT_THAT(refusal(bar(), options).what(), Not(HasSubstr("nothing was refused")));
}

TEST(LatticeInput, RefusesAskingBeyondItsLattice) {
  const SectionLattice lattice(bar(), {});

  EXPECT_THROW(static_cast<void>(lattice.keyPoint_m(36, 0)), ContractError);
  EXPECT_THROW(static_cast<void>(lattice.sectionArc_m(-1)), ContractError);
  EXPECT_THROW(static_cast<void>(lattice.outline_m(25)), ContractError);
  EXPECT_THROW(static_cast<void>(lattice.surfacePoint({kNaN, 0.0})), ContractError);
}

}  // namespace

}  // namespace torsio
