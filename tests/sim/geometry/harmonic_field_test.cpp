// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/harmonic_field.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/core/portable_math.h"
#include "sim/core/random.h"
#include "sim/geometry/lattice/level_loops.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

/// A J-shaped tube whose vertices were pushed about along the surface: thin, slanted triangles.
TriangleMesh roughTube() {
  TriangleMesh mesh = testing::jTube(0.02, 0.12, 0.04, 40, 70);
  Random random(7);
  constexpr double kPush_m = 0.0008;
  for (Vec3& p : mesh.vertices_m) {
    p += kPush_m * Vec3{random.normal(), random.normal(), random.normal()};
  }
  return mesh;
}

struct Solved {
  TriangleMesh mesh;
  SurfaceTopology topology;
  EndCaps caps;
  HarmonicField field;

  explicit Solved(TriangleMesh surface)
      : mesh(std::move(surface)),
        topology(mesh),
        caps(findEndCaps(mesh, topology, {})),
        field(solveHarmonicField(mesh, topology, caps.parts)) {}
};

TEST(HarmonicField, IsLinearOnAPrism) {
  const Solved bar(testing::prism(testing::ellipseOutline(0.04, 0.02, 48), 0.2, 20));

  for (std::size_t v = 0; v < bar.mesh.vertices_m.size(); ++v) {
    EXPECT_NEAR(bar.field.level[v], bar.mesh.vertices_m[v].z / 0.2, 1e-12);
  }
}

TEST(HarmonicField, HasNoExtremumBetweenTheCaps) {
  const Solved tube(roughTube());

  for (std::uint32_t v = 0; v < tube.topology.vertices(); ++v) {
    const double here = tube.field.level[v];
    EXPECT_GE(here, 0.0);
    EXPECT_LE(here, 1.0);
    if (tube.caps.parts[v] != LatticePart::kSide) {
      continue;
    }
    double least = 2.0;
    double most = -1.0;
    for (const std::uint32_t half : tube.topology.outgoing(v)) {
      least = std::min(least, tube.field.level[tube.topology.target(half)]);
      most = std::max(most, tube.field.level[tube.topology.target(half)]);
    }
    EXPECT_LT(least, here) << v;
    EXPECT_GT(most, here) << v;
  }
}

TEST(HarmonicField, HasOneLoopAtEveryLevel) {
  const Solved tube(roughTube());
  const LevelTracer tracer(tube.mesh, tube.topology, tube.field);
  std::vector<double> levels;
  for (int k = 0; k <= 500; ++k) {
    levels.push_back(k / 500.0);
  }

  int traced = 0;
  tracer.traceAll(levels, [&](std::size_t k, const std::vector<LevelLoop>& loops) {
    ++traced;
    ASSERT_EQ(loops.size(), 1U) << k;
    // The angle rises by one turn on the way round.
    EXPECT_NEAR(loops.front().turn_rad, 2.0 * kPi, 1e-9) << k;
  });
  EXPECT_EQ(traced, 501);
}

TEST(HarmonicField, RisesRoundEveryTriangleToNothing) {
  const Solved tube(roughTube());

  for (std::uint32_t t = 0; t < tube.mesh.triangles.size(); ++t) {
    if (!isSideTriangle(tube.mesh.triangles[t], tube.caps.parts)) {
      continue;
    }
    double sum = 0.0;
    for (std::uint32_t k = 0; k < 3; ++k) {
      sum += tube.field.rise_rad(tube.topology, 3 * t + k);
    }
    EXPECT_NEAR(sum, 0.0, 1e-12) << t;
  }
}

TEST(HarmonicField, TurnsEquallyRoundACircularBar) {
  const Solved bar(testing::prism(testing::circleOutline(0.03, 36), 0.2, 12));

  for (std::uint32_t v = 36; v + 36 < bar.mesh.vertices_m.size(); ++v) {
    const std::uint32_t next = v % 36 == 35 ? v - 35 : v + 1;
    for (const std::uint32_t half : bar.topology.outgoing(v)) {
      if (bar.topology.target(half) != next) {
        continue;
      }
      EXPECT_NEAR(bar.field.rise_rad(bar.topology, half), 2.0 * kPi / 36, 1e-9) << v;
    }
  }
}

TEST(LevelTracer, MeasuresTheLoopOfASquareBar) {
  const Solved bar(testing::prism(testing::rectangleOutline(0.04, 0.03, 3), 0.2, 8));
  const LevelTracer tracer(bar.mesh, bar.topology, bar.field);

  const std::vector<LevelLoop> loops = tracer.trace(0.4375);

  ASSERT_EQ(loops.size(), 1U);
  EXPECT_NEAR(loops[0].perimeter_m, 0.14, 1e-12);
  EXPECT_NEAR(loops[0].areaVector_m2.z, 0.0012, 1e-12);
  EXPECT_NEAR(norm(loops[0].centroid_m - Vec3{0, 0, 0.4375 * 0.2}), 0.0, 1e-12);
}

TEST(LevelTracer, TracesManyLevelsAsItTracesOne) {
  const Solved tube(roughTube());
  const LevelTracer tracer(tube.mesh, tube.topology, tube.field);
  const std::vector<double> levels{0.0, 0.1, 0.33, 0.7, 1.0};

  tracer.traceAll(levels, [&](std::size_t k, const std::vector<LevelLoop>& loops) {
    const std::vector<LevelLoop> alone = tracer.trace(levels[k], k + 1 == levels.size());
    ASSERT_EQ(loops.size(), alone.size());
    EXPECT_NEAR(loops[0].perimeter_m, alone[0].perimeter_m, 1e-12);
    EXPECT_LT(norm(loops[0].centroid_m - alone[0].centroid_m), 1e-12);
  });
}

TEST(LevelTracer, EndsOnTheRimsOfTheCaps) {
  const Solved bar(testing::prism(testing::circleOutline(0.03, 24), 0.2, 10));
  const LevelTracer tracer(bar.mesh, bar.topology, bar.field);
  const double area = testing::areaOf(testing::circleOutline(0.03, 24));

  const LevelLoop low = tracer.trace(0.0).at(0);
  const LevelLoop high = tracer.trace(1.0, true).at(0);

  EXPECT_NEAR(low.areaVector_m2.z, area, 1e-12);
  EXPECT_NEAR(low.centroid_m.z, 0.0, 1e-15);
  EXPECT_NEAR(high.areaVector_m2.z, area, 1e-12);
  EXPECT_NEAR(high.centroid_m.z, 0.2, 1e-15);
}

TEST(EndCaps, AreTheFlatEndsOfABarAndNeverItsSides) {
  const TriangleMesh mesh = testing::prism(testing::rectangleOutline(0.06, 0.05, 4), 0.1, 6);
  const SurfaceTopology topology(mesh);

  const EndCaps caps = findEndCaps(mesh, topology, {});

  EXPECT_TRUE(caps.fixedFlat);
  EXPECT_TRUE(caps.freeFlat);
  EXPECT_NEAR(norm(caps.fixedCentre_m), 0.0, 1e-12);
  EXPECT_NEAR(norm(caps.freeCentre_m - Vec3{0, 0, 0.1}), 0.0, 1e-12);
  for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
    const double z = mesh.vertices_m[v].z;
    const LatticePart part = z == 0.0   ? LatticePart::kFixedCap
                             : z == 0.1 ? LatticePart::kFreeCap
                                        : LatticePart::kSide;
    EXPECT_EQ(caps.parts[v], part) << v;
  }
}

TEST(EndCaps, ClosesHolesSoThatTheSideIsATube) {
  // A disc wider than the thin end of the bar would cut off its tip.
  const TriangleMesh mesh = testing::prism(testing::circleOutline(0.03, 24), 0.2, 20, 0.2);
  const SurfaceTopology topology(mesh);
  CapRequest request;
  request.fixedEnd_m = {0.03, 0, 0};
  request.freeEnd_m = {0.0105, 0, 0.16};
  request.capRadius_m = 0.038;

  const EndCaps caps = findEndCaps(mesh, topology, request);

  for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
    if (mesh.vertices_m[v].z < 0.2) {
      continue;
    }
    EXPECT_EQ(caps.parts[v], LatticePart::kFreeCap) << v;
  }
  EXPECT_NO_THROW(solveHarmonicField(mesh, topology, caps.parts));
}

}  // namespace
}  // namespace torsio
