// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_skin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/tissue/rod/fold_check.h"
#include "sim/tissue/rod/rod_solve.h"
#include "tests/support/allocation_count.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

constexpr double kSkinLength_m = 0.24;

/// An organ with its rod and its skin.
struct SkinnedOrgan {
  explicit SkinnedOrgan(TriangleMesh surface)
      : mesh(std::move(surface)),
        lattice(mesh, automatic()),
        sections(SolvedSections::solve(lattice, {})),
        organ(rodOfOrgan(lattice, sections, {1e4, 0.5})),
        skin(organ, lattice, sections, mesh) {}

  static LatticeOptions automatic() { return {.sections = 13, .mode = LatticeMode::kAutomatic}; }
  [[nodiscard]] RodPose turned(double angle_deg) const {
    const Rod rod(organ.elements, organ.rest, organ.radii_m);
    return solveTurned(rod, {.angle_rad = radians(angle_deg)}).pose;
  }
  [[nodiscard]] std::vector<Vec3> drawn(const RodPose& pose) const {
    std::vector<Vec3> vertices(mesh.vertices_m.size());
    skin.deform(skin.curveOf(pose), vertices);
    return vertices;
  }

  TriangleMesh mesh;
  SectionLattice lattice;
  SolvedSections sections;
  OrganRod organ;
  RodSkin skin;
};

SkinnedOrgan bentOrgan() {
  return SkinnedOrgan(testing::bentTube(0.025, kSkinLength_m / 2.0, 2.0, 48, 60));  // radius over bend 0.21
}

double largestDistance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    most = std::max(most, norm(a[v] - b[v]));
  }
  return most;
}

/// Points inside the organ: between its axis and its vertices.
std::vector<Vec3> insideOf(const SkinnedOrgan& o) {
  std::vector<Vec3> points;
  for (std::size_t v = 0; v < o.mesh.vertices_m.size(); v += 29) {
    const Vec3& p = o.mesh.vertices_m[v];
    const Vec3 axis = o.lattice.frameAt(o.lattice.vertexCoordinates()[v].arc_m).centre_m;
    for (const double depth : {0.1, 0.6, 0.98}) {
      points.push_back(axis + depth * (p - axis));
    }
  }
  return points;
}

double determinant(const SkinnedOrgan& o, const RodCurve& curve, const Vec3& p) {
  constexpr double kStep = 1e-6;
  const auto column = [&](const Vec3& step) {
    return (o.skin.toDeformed_m(p + step, curve) - o.skin.toDeformed_m(p - step, curve)) / (2.0 * kStep);
  };
  return dot(column({kStep, 0, 0}), cross(column({0, kStep, 0}), column({0, 0, kStep})));
}

TEST(RodSkin, TheOrganAtRestIsGivenBackToABillionthOfAMillimetre) {
  for (const SkinnedOrgan& o : {bentOrgan(), SkinnedOrgan(testing::capsule(0.02, kSkinLength_m, 48, 40))}) {
    EXPECT_LT(largestDistance(o.drawn(o.organ.rest), o.mesh.vertices_m), 1e-12);
    const RodCurve rest = o.skin.curveOf(o.organ.rest);
    for (const Vec3& p : insideOf(o)) {
      EXPECT_LT(norm(o.skin.toDeformed_m(p, rest) - p), 1e-12);
    }
  }
}

TEST(RodSkin, EveryVolumeIsKeptHoweverTheRodIsTwistedAndBent) {
  const SkinnedOrgan o = bentOrgan();
  for (const double angle_deg : {40.0, 170.0}) {
    const RodPose pose = o.turned(angle_deg);
    const RodCurve curve = o.skin.curveOf(pose);

    for (const Vec3& p : insideOf(o)) {
      EXPECT_NEAR(determinant(o, curve, p), 1.0, 1e-6) << angle_deg;
    }
    TriangleMesh now = o.mesh;
    now.vertices_m = o.drawn(pose);
    // What is left is the chords of the triangles, which cut off more of a twisted surface.
    EXPECT_NEAR(signedVolume_m3(now) / signedVolume_m3(o.mesh), 1.0, 0.003) << angle_deg;
  }
}

TEST(RodSkin, IsWholeAcrossTheNodesOfTheRod) {
  // A thin tube, 20 degrees an element and more: just before and just behind a node lies the same tissue.
  const SkinnedOrgan o(testing::bentTube(0.008, 0.03, 2.5, 32, 60));
  const RodCurve curve = o.skin.curveOf(o.turned(360.0));

  for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(curve.count); ++i) {
    for (const std::array<double, 2>& section :
         {std::array{0.0, 0.0}, std::array{0.007, 0.0}, std::array{0.0, -0.007}}) {
      const RodSkinPlace before{.arc_m = curve.arcs_m[i] - 1e-13, .section_m = section};
      const RodSkinPlace behind{.arc_m = curve.arcs_m[i] + 1e-13, .section_m = section};
      EXPECT_LT(norm(o.skin.positionOf_m(before, curve) - o.skin.positionOf_m(behind, curve)), 1e-11) << i;
    }
  }
}

TEST(RodSkin, AStretchedOrganThinsByTheRootOfItsStretch) {
  const SkinnedOrgan o(testing::prism(testing::circleOutline(0.02, 48), kSkinLength_m, 48));
  RodPose pose = o.organ.rest;
  for (int i = 0; i < pose.count; ++i) {
    pose.nodes[static_cast<std::size_t>(i)].position_m.z *= 1.21;
  }

  const std::vector<Vec3> drawn = o.drawn(pose);

  for (std::size_t v = 0; v < drawn.size(); ++v) {
    const Vec3& rest = o.mesh.vertices_m[v];
    EXPECT_NEAR(drawn[v].z, 1.21 * rest.z, 1e-12);
    EXPECT_NEAR(std::hypot(drawn[v].x, drawn[v].y), std::hypot(rest.x, rest.y) / 1.1, 1e-12);
  }
}

TEST(RodSkin, ABentSectionKeepsItsAreaAlongEveryFibre) {
  // Bent to a circle: a curve of radius rho with stretch g = rho / (1 / kappa); a fibre u inside of the axis
  // has the length g (1 - u / rho) of the axis at rest, so that u - u^2 / (2 rho) is its place at rest over
  // sqrt(g).
  const SkinnedOrgan o(testing::prism(testing::circleOutline(0.02, 48), kSkinLength_m, 48));
  const double bend = 0.08;
  RodPose pose = o.organ.rest;
  for (int i = 0; i < pose.count; ++i) {
    Pose& node = pose.nodes[static_cast<std::size_t>(i)];
    const double at = o.organ.arcs_m[static_cast<std::size_t>(i)] / bend;
    node.orientation = axisAngle({0, 1, 0}, at) * node.orientation;
    node.position_m = {bend * (1.0 - std::cos(at)), 0.0, bend * std::sin(at)};
  }

  const RodCurve curve = o.skin.curveOf(pose);

  const auto fromCentre = [&](double x) {
    const Vec3 p = o.skin.toDeformed_m({x, 0.0, 0.5 * kSkinLength_m}, curve);
    return std::hypot(p.x - bend, p.z);
  };
  const double rho = fromCentre(0.0);  // the curve is smoothed: a little less than the bend of the nodes
  EXPECT_NEAR(rho / bend, 0.985, 0.01);
  for (const double rest : {-0.019, -0.008, 0.008, 0.019}) {
    const double inside = rho - fromCentre(rest);
    EXPECT_NEAR((inside - inside * inside / (2.0 * rho)) * std::sqrt(rho / bend), rest, 1e-5);
  }
}

TEST(RodSkin, ATwistedEllipseWarpsByTheClosedForm) {
  // psi = -(a^2 - b^2) / (a^2 + b^2) x y, flat at the held ends.
  const double a = 0.03;
  const double b = 0.02;
  const SkinnedOrgan o(testing::prism(testing::ellipseOutline(a, b, 96), kSkinLength_m, 48));
  const double rate = radians(30.0) / kSkinLength_m;

  const std::vector<Vec3> drawn = o.drawn(o.turned(30.0));

  double most = 0.0;
  for (std::size_t v = 0; v < drawn.size(); ++v) {
    const Vec3& rest = o.mesh.vertices_m[v];
    if (rest.z < 0.03 || rest.z > kSkinLength_m - 0.03) {
      continue;
    }
    const double psi = -(a * a - b * b) / (a * a + b * b) * rest.x * rest.y;
    EXPECT_NEAR(drawn[v].z - rest.z, rate * psi, 1e-6);
    most = std::max(most, std::abs(rate * psi));
  }
  EXPECT_GT(most, 2e-4);
  EXPECT_NEAR(drawn.front().z, 0.0, 1e-9);
}

TEST(RodSkin, ThePlaceAtRestIsFoundAgain) {
  const SkinnedOrgan o = bentOrgan();
  const RodCurve curve = o.skin.curveOf(o.turned(120.0));
  for (const Vec3& p : insideOf(o)) {
    EXPECT_LT(norm(o.skin.toRest_m(o.skin.toDeformed_m(p, curve), curve) - p), 1e-11);
  }
}

TEST(RodSkin, ABendSharperThanTheSectionAllowsStaysOneToOne) {
  // Bent to 1.05 radii: the inner fibres would have to be shorter than nothing without the limit.
  const SkinnedOrgan o(testing::prism(testing::circleOutline(0.02, 48), kSkinLength_m, 48));
  RodPose pose = o.organ.rest;
  const double rho = 0.021;
  for (int i = 0; i < pose.count; ++i) {
    Pose& node = pose.nodes[static_cast<std::size_t>(i)];
    const double at = (o.organ.arcs_m[static_cast<std::size_t>(i)] - 0.10) / rho;
    const double in = std::clamp(at, 0.0, 1.0);
    node.orientation = axisAngle({0, 1, 0}, in) * node.orientation;
    const double out = rho * (at - in);
    node.position_m = {rho * (1.0 - std::cos(in)) + out * std::sin(in), 0.0,
                       0.10 + rho * std::sin(in) + out * std::cos(in)};
  }
  const RodCurve curve = o.skin.curveOf(pose);
  for (const Vec3& p : insideOf(o)) {
    EXPECT_GT(determinant(o, curve, p), 0.0);
    EXPECT_LT(norm(o.skin.toRest_m(o.skin.toDeformed_m(p, curve), curve) - p), 1e-7);
  }
}

TEST(RodSkin, QueriesAllocateNothing) {
  const SkinnedOrgan o = bentOrgan();
  const RodPose pose = o.turned(60.0);
  std::vector<Vec3> out(o.mesh.vertices_m.size());

  const std::int64_t before = testing::allocationCount();
  const RodCurve curve = o.skin.curveOf(pose);
  o.skin.deform(curve, out);
  const Vec3 there = o.skin.toDeformed_m(o.mesh.vertices_m[7], curve);
  const Vec3 back = o.skin.toRest_m(there, curve);
  const std::int64_t after = testing::allocationCount();

  EXPECT_EQ(after, before);
  EXPECT_LT(norm(back - o.mesh.vertices_m[7]), 1e-11);
}

LatticeOptions nineSections() {
  return {.sections = 9, .mode = LatticeMode::kAutomatic};
}

/// A bar of 200 mm with its check.
struct CheckedBar {
  TriangleMesh mesh = testing::prism(testing::circleOutline(0.02, 32), 0.2, 20);
  SectionLattice lattice{mesh, nineSections()};
  FoldCheck check{mesh, lattice};

  [[nodiscard]] FoldReport judge(const std::function<Vec3(const Vec3&)>& map) const {
    std::vector<Vec3> vertices;
    for (const Vec3& p : mesh.vertices_m) {
      vertices.push_back(map(p));
    }
    return check.judge(vertices, map);
  }
};

TEST(FoldCheck, AnOrganAtRestIsNotFolded) {
  const FoldReport report = CheckedBar().judge([](const Vec3& p) { return p; });
  EXPECT_FALSE(report.folded());
  EXPECT_EQ(report.volumeRatio, 1.0);
  EXPECT_NEAR(report.minDeterminant, 1.0, 1e-9);
  EXPECT_NEAR(report.maxDeterminant, 1.0, 1e-9);
  EXPECT_EQ(report.crossings, 0U);
  EXPECT_TRUE(report.reason().empty());
}

TEST(FoldCheck, SwellingByMoreThanAFiftiethIsJudged) {
  const CheckedBar bar;
  const auto swollen = [](double by) { return [by](const Vec3& p) { return Vec3{by * p.x, p.y, p.z}; }; };
  EXPECT_FALSE(bar.judge(swollen(1.019)).folded());
  EXPECT_FALSE(bar.judge(swollen(0.981)).folded());
  const FoldReport more = bar.judge(swollen(1.021));
  EXPECT_TRUE(more.folded());
  EXPECT_NEAR(more.volumeRatio, 1.021, 1e-12);
  EXPECT_EQ(more.reason().str(), "the volume becomes 1.02 of what it was");
  EXPECT_TRUE(bar.judge(swollen(0.979)).folded());
}

TEST(FoldCheck, TissueThatLosesItsVolumeInOnePlaceIsJudged) {
  // z -> z + a sin(z / b) has det F = 1 + (a / b) cos(z / b): least 1 - a / b.
  const CheckedBar bar;
  const double b = 0.2 / 25.132741228718345;  // four waves along the bar
  const auto squeezed = [b](double least) {
    return [b, least](const Vec3& p) {
      return Vec3{p.x, p.y, p.z + (1.0 - least) * b * std::sin(p.z / b + 3.0)};
    };
  };
  EXPECT_FALSE(bar.judge(squeezed(0.3)).folded());
  const FoldReport report = bar.judge(squeezed(0.05));
  EXPECT_TRUE(report.folded());
  EXPECT_LT(report.minDeterminant, 0.2);
  EXPECT_NE(report.reason().str().find("det F"), std::string::npos);
}

TEST(FoldCheck, ASurfaceThatCrossesItselfIsJudgedButNotOneThatDidAtRest) {
  // The upper half is pushed sideways through nothing: a bar bent back onto itself.
  const CheckedBar bar;
  std::vector<Vec3> vertices = bar.mesh.vertices_m;
  for (Vec3& p : vertices) {
    if (p.z > 0.15) {
      p = {p.x + 0.01, p.y, p.z - 0.12};
    }
  }
  const auto rest = [](const Vec3& p) { return p; };

  const FoldReport report = bar.check.judge(vertices, rest);

  EXPECT_GT(report.crossings, 0U);
  EXPECT_TRUE(report.folded());
  TriangleMesh crossed = bar.mesh;
  crossed.vertices_m = vertices;
  const FoldCheck used(crossed, bar.lattice);
  EXPECT_EQ(used.judge(vertices, rest).crossings, 0U);
}

}  // namespace
}  // namespace torsio
