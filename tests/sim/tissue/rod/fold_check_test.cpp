// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/fold_check.h"

#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

LatticeOptions nineSections() {
  LatticeOptions options{.sections = 9, .mode = LatticeMode::kAutomatic};
  return options;
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
