// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/harmonic_field.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/core/portable_math.h"
#include "sim/core/random.h"
#include "sim/geometry/lattice/centreline.h"
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

/// A helix of radius a and rise 2 pi b a turn, by angle.
Vec3 helix(double angle) {
  return {0.03 * std::cos(angle), 0.03 * std::sin(angle), 0.02 * angle};
}

std::vector<Vec3> helixPoints(int count, double turns) {
  std::vector<Vec3> points;
  for (int i = 0; i <= count; ++i) {
    points.push_back(helix(2.0 * kPi * turns * i / count));
  }
  return points;
}

TEST(Centreline, LeavesAStraightLineAsItIs) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 30; ++i) {
    points.push_back({0.01 * i * i, -0.02 * i * i, 0.005 * i * i});
  }
  std::vector<double> arcs;

  const Centreline line = Centreline::curved(points, 0.02, 256, {0, 0, 1}, 0.0, arcs);

  const double length = norm(points.back() - points.front());
  EXPECT_NEAR(line.length_m(), length, 1e-13);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(arcs[i], norm(points[i] - points.front()), 1e-12);
    EXPECT_LT(norm(line.frameAt(arcs[i]).centre_m - points[i]), 1e-12);
  }
  EXPECT_LT(norm(line.frameAt(0.0).e1 - line.frameAt(length).e1), 1e-12);
}

TEST(Centreline, KeepsTheRadiusOfABendWhenItSmoothes) {
  std::vector<double> arcs;
  std::vector<Vec3> circle;
  for (int i = 0; i <= 400; ++i) {
    const double angle = kPi * i / 400;
    circle.push_back({0.05 * std::cos(angle), 0.05 * std::sin(angle), 0.0});
  }

  const Centreline line = Centreline::curved(circle, 0.003, 256, {0, 0, 1}, 0.0, arcs);

  // One Gaussian of 3 mm would pull the bend in by s^2 / (2 r) = 0.09 mm; twice leaves a hundredth of it.
  for (int k = 20; k <= 80; ++k) {
    EXPECT_NEAR(norm(line.frameAt(line.length_m() * k / 100).centre_m), 0.05, 2e-6);
  }
}

TEST(Centreline, TakesTheStepsOfTheMeshOutOfALine) {
  Random random(3);
  std::vector<Vec3> points;
  for (int i = 0; i <= 400; ++i) {
    points.push_back({2e-4 * random.normal(), 2e-4 * random.normal(), 0.0005 * i});
  }
  std::vector<double> arcs;

  const Centreline line = Centreline::curved(points, 0.003, 256, {1, 0, 0}, 0.0, arcs);

  EXPECT_NEAR(line.length_m(), 0.2, 2e-3);  // the raw polyline is 1.2 times as long
  for (int k = 5; k < 95; ++k) {
    EXPECT_GT(line.frameAt(line.length_m() * k / 100).tangent.z, 0.99);
  }
}

TEST(Centreline, HasOrthonormalFramesThatDoNotTurnAboutIt) {
  std::vector<double> arcs;

  const Centreline line = Centreline::curved(helixPoints(2000, 2.0), 0.001, 512, {0, 0, 1}, 0.5, arcs);

  // The rotation-minimising frame lags behind the Frenet frame by the integral of the torsion:
  // tau = b / (a^2 + b^2) for the helix of radius a = 30 mm and rise b = 20 mm a radian.
  const double torsion = 0.02 / (0.03 * 0.03 + 0.02 * 0.02);
  const auto againstFrenet = [&](double arc) {
    const AxisFrame f = line.frameAt(arc);
    const Vec3 inwards = normalized(Vec3{-f.centre_m.x, -f.centre_m.y, 0});
    const Vec3 normal = normalized(inwards - dot(inwards, f.tangent) * f.tangent);
    return std::atan2(dot(normal, f.e2), dot(normal, f.e1));
  };
  double last = againstFrenet(0.1 * line.length_m());
  for (int k = 11; k <= 90; ++k) {
    const double arc = line.length_m() * k / 100;
    const AxisFrame f = line.frameAt(arc);
    EXPECT_NEAR(norm(f.tangent), 1.0, 1e-14);
    EXPECT_NEAR(norm(f.e1), 1.0, 1e-14);
    EXPECT_NEAR(dot(f.e1, f.tangent), 0.0, 1e-14);
    EXPECT_LT(norm(cross(f.e1, f.e2) - f.tangent), 1e-13);
    const double here = againstFrenet(arc);
    EXPECT_NEAR(std::remainder(here - last, 2.0 * kPi), torsion * line.length_m() / 100, 2e-3) << k;
    last = here;
  }
}

TEST(Centreline, PutsE1WhereAsked) {
  std::vector<double> arcs;

  const Centreline line = Centreline::curved(helixPoints(2000, 1.0), 0.001, 256, {0, 0, 1}, 0.5, arcs);

  const AxisFrame middle = line.frameAt(0.5 * line.length_m());
  const Vec3 up{0, 0, 1};
  const Vec3 across = normalized(up - dot(up, middle.tangent) * middle.tangent);
  EXPECT_LT(norm(middle.e1 - across), 1e-12);
}

TEST(Centreline, IsSmoothBetweenItsStations) {
  std::vector<double> arcs;
  const Centreline line = Centreline::curved(helixPoints(400, 1.0), 0.001, 64, {0, 0, 1}, 0.0, arcs);
  constexpr double kStep = 1e-7;

  for (int i = 1; i < 64; ++i) {
    const double station = line.length_m() * i / 64;
    const AxisFrame before = line.frameAt(station - kStep);
    const AxisFrame after = line.frameAt(station + kStep);
    EXPECT_LT(norm(after.centre_m - before.centre_m), 3 * kStep);
    EXPECT_LT(norm(after.tangent - before.tangent), 1e-4);  // curvature is 23 / m: 5e-6 expected
    EXPECT_LT(norm(after.e1 - before.e1), 1e-4);
  }
}

TEST(Centreline, ClampsWhatLiesBeyondItsEnds) {
  std::vector<double> arcs;
  const Centreline line = Centreline::curved(helixPoints(100, 0.5), 0.001, 64, {0, 0, 1}, 0.0, arcs);

  EXPECT_EQ(line.frameAt(-1.0).centre_m, line.frameAt(0.0).centre_m);
  EXPECT_EQ(line.frameAt(9.0).centre_m, line.frameAt(line.length_m()).centre_m);
  EXPECT_EQ(line.nearestArc_m(helix(0.0) + Vec3{0, -0.01, -0.01}), 0.0);
  EXPECT_EQ(line.nearestArc_m(helix(kPi) + Vec3{0, -0.01, 0.01}), line.length_m());
}

TEST(Centreline, MeasuresHeightsAlongAStraightAxisWhateverTheCentresDo) {
  std::vector<Vec3> centres;
  for (int i = 0; i <= 20; ++i) {
    centres.push_back({0.01 * std::sin(0.3 * i), 0.0, 0.01 * i});
  }

  const Centreline line = Centreline::straightAlong({0, 0, 1}, 0.2, centres, {0, 1, 0});

  EXPECT_TRUE(line.straight());
  for (int i = 0; i <= 20; ++i) {
    EXPECT_LT(norm(line.frameAt(0.01 * i).centre_m - centres[static_cast<std::size_t>(i)]), 1e-15);
    EXPECT_EQ(line.frameAt(0.01 * i + 0.003).tangent, (Vec3{0, 0, 1}));
    EXPECT_EQ(line.frameAt(0.01 * i + 0.003).e1, (Vec3{0, 1, 0}));
  }
  EXPECT_NEAR(line.nearestArc_m({0.5, -0.3, 0.0777}), 0.0777, 1e-15);
}

}  // namespace
}  // namespace torsio
