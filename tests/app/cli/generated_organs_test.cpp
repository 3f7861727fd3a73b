// SPDX-License-Identifier: GPL-3.0-or-later
// Organs drawn by chance: bends, tapers, elliptic sections, bumps, waists, noise. What is accepted can be
// twisted, everywhere on the way to the target, and by a hand.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "app/cli/rod_twist.h"
#include "sim/core/angle.h"
#include "sim/core/random.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/organ_fit.h"
#include "sim/scene/rod_organ.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/servo_loop.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

const std::filesystem::path kAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

/// A tube of a bowel's to a stomach's size whose features are drawn from a seed.
TriangleMesh drawnTube(std::uint64_t seed) {
  Random random = Random::forStream(seed, 1);
  const auto between = [&random](double low, double high) { return low + (high - low) * random.uniform(); };
  const double radius_m = between(0.012, 0.04);
  const double length_m = radius_m * between(4.0, 10.0);
  const double bend_rad = between(0.0, 1.0) < 0.3 ? 0.0 : between(0.2, 3.2);
  const double roll_rad = between(-1.0, 1.0);
  const double taper = between(0.5, 1.2);
  const double aspect = between(1.0, 1.8);
  const double waist = between(0.0, 1.0) < 0.3 ? between(0.5, 0.9) : 1.0;
  const double waistAt = between(0.3, 0.7);
  const double bump = between(0.0, 1.0) < 0.3 ? between(0.2, 0.9) : 0.0;
  const double bumpAt = between(0.25, 0.75);
  const double bumpSide_rad = between(0.0, kTurn);
  const double noise = between(0.0, 0.03);
  const double phase_rad = between(0.0, kTurn);
  constexpr int kPoints = 40;
  constexpr int kRings = 60;
  TriangleMesh tube = testing::sweep(
      testing::ellipseOutline(radius_m * std::sqrt(aspect), radius_m / std::sqrt(aspect), kPoints), kRings,
      [&](double t) {
        const double turn_rad = bend_rad * t;
        const double reach_m = bend_rad > 0.0 ? length_m / bend_rad : 0.0;
        const Vec3 centre_m =
            bend_rad > 0.0 ? Vec3{reach_m * (1.0 - std::cos(turn_rad)), 0, reach_m * std::sin(turn_rad)}
                           : Vec3{0, 0, length_m * t};
        const Vec3 out{std::cos(turn_rad), 0, -std::sin(turn_rad)};
        const Vec3 side{0, 1, 0};
        const double c = std::cos(roll_rad * t);
        const double s = std::sin(roll_rad * t);
        const double away = (t - waistAt) / 0.1;
        const double scale = (1.0 + t * (taper - 1.0)) * (1.0 - (1.0 - waist) * std::exp(-away * away));
        return testing::SweepFrame{centre_m, c * out + s * side, c * side - s * out, scale};
      });
  // The first vertices are the rings: bumps and noise move them away from the middle of their ring.
  for (int ring = 0; ring <= kRings; ++ring) {
    Vec3 middle_m;
    for (int i = 0; i < kPoints; ++i) {
      middle_m += tube.vertices_m[static_cast<std::size_t>(ring * kPoints + i)] * (1.0 / kPoints);
    }
    for (int i = 0; i < kPoints; ++i) {
      Vec3& vertex_m = tube.vertices_m[static_cast<std::size_t>(ring * kPoints + i)];
      const double t = static_cast<double>(ring) / kRings;
      const double around_rad = kTurn * i / kPoints;
      const double along = (t - bumpAt) * length_m / (0.6 * radius_m);
      const double facing = std::max(0.0, std::cos(around_rad - bumpSide_rad));
      const double grown = bump * facing * facing * std::exp(-along * along) +
                           noise * std::sin(3.0 * around_rad + 20.0 * t + phase_rad);
      vertex_m = middle_m + (1.0 + grown) * (vertex_m - middle_m);
    }
  }
  return tube;
}

Scene sceneOf(const OrganFile& organ, const std::string& pattern) {
  SceneRequest request;
  request.assets = kAssets;
  request.organFile = "drawn.organ";
  request.pattern = pattern;
  return sceneOfOrgan(request, organ);
}

/// A twist to any angle on the way to the target is no fold.
void expectWhole(const Scene& scene) {
  const FoldCheck check(scene.mesh, scene.lattice());
  for (const double share : {0.001, 0.19, 0.56, 0.93, 1.0}) {
    const double angle_rad = share * scene.pattern.targetAngle_rad;
    if (scene.rod) {
      ASSERT_TRUE(reaches(scene.rod->path(), angle_rad)) << share;
    }
    const FoldReport fold = foldOf(scene, check, scene.stateAt(angle_rad));
    EXPECT_FALSE(fold.folded()) << share << ": " << fold.reason();
  }
}

/// An organ that comes twisted is whole at every turn, both ways if a trial may begin either way, and finds a
/// balance at every pressure of its gas.
void expectWholeAsItComes(const Scene& scene) {
  const FoldCheck check(scene.mesh, scene.lattice());
  const InitialTwist& start = scene.hollow->detorsion().start;
  for (const double share : {0.001, 0.19, 0.56, 0.93, 1.0, -0.37, -1.0}) {
    if (share < 0.0 && start.oppositeShare <= 0.0) {
      continue;
    }
    OrganState state = scene.stateAt(share * start.sign * start.most_rad);
    const BrokenLimit broken = brokenLimit(scene, foldOf(scene, check, state));
    EXPECT_TRUE(broken.code.empty()) << share << ": " << broken.reason;
    for (const double left : {1.0, 0.4, 0.0}) {
      const double pressure_Pa = left * scene.hollow->detorsion().wall.pressure_Pa;
      EXPECT_TRUE(std::isfinite(scene.hollow->torque_Nm(state.twist.graspAngle_rad, pressure_Pa)));
    }
  }
}

/// A hand untwists it, or tries to: every tick has an answer.
void expectUntwisted(const Scene& scene) {
  ScriptedHand hand({.seed = 1,
                     .task = handTask(scene),
                     .profile = {.initialSkill = 0.9, .finalSkill = 0.9},
                     .duration_s = 4.0});
  ServoLoop loop({.device = &hand, .scene = &scene}, {});
  for (std::int64_t time_us = 0; time_us < 4'000'000; time_us += kTickPeriod_us) {
    loop.tick(time_us);
    const TwistResponse& response = loop.lastSample().response;
    ASSERT_TRUE(std::isfinite(response.torque_Nm) && std::isfinite(response.angle_rad)) << time_us;
  }
}

/// Its ends can be held and turned (`torsio twist --ends`): every turn up to half of one has an answer, and
/// one that is said to hold is no fold.
void expectEndsTurn(const Scene& scene) {
  cli::RodTwistRequest request;
  request.shearModulus_Pa = scene.model.material().shearModulus_Pa;
  for (const cli::RodEnds ends : {cli::RodEnds::kClampedTurned, cli::RodEnds::kClampedFree}) {
    request.ends = ends;
    request.grasp = ends == cli::RodEnds::kClampedFree ? 0.6 : 1.0;
    for (const double angle_deg : {20.0, -180.0}) {
      request.angle_rad = radians(angle_deg);
      SCOPED_TRACE(angle_deg);
      const cli::RodTwistResult twist = cli::rodTwist(scene, request);
      EXPECT_TRUE(std::isfinite(twist.torque_Nm));
      EXPECT_EQ(twist.beyond.empty(), !twist.fold.folded() && twist.angle_rad == request.angle_rad);
      EXPECT_TRUE(angle_deg != 20.0 || twist.beyond.empty()) << twist.beyond;
    }
  }
}

/// A hand turns it.
void expectTurned(const Scene& scene) {
  ScriptedHandOptions options{.seed = 1,
                              .task = handTask(scene),
                              .profile = {.initialSkill = 0.9, .finalSkill = 0.9},
                              .duration_s = 1.0};
  options.duration_s = ScriptedHand(options).span_s(0)[1];
  ScriptedHand hand(options);
  ServoLoop loop({.device = &hand, .scene = &scene}, {});
  double reached_rad = 0.0;
  for (std::int64_t time_us = 0; time_us < static_cast<std::int64_t>(options.duration_s * 1e6);
       time_us += kTickPeriod_us) {
    loop.tick(time_us);
    const TwistResponse& response = loop.lastSample().response;
    ASSERT_TRUE(std::isfinite(response.torque_Nm) && std::isfinite(response.angle_rad)) << time_us;
    reached_rad = std::max(reached_rad, std::abs(response.angle_rad));
  }
  EXPECT_GT(reached_rad, 0.5 * std::abs(scene.pattern.targetAngle_rad));
}

TEST(GeneratedOrgans, AreTwistedWhereTheyAreAccepted) {
  int accepted = 0;
  int patterns = 0;
  int twisted = 0;
  for (std::uint64_t seed = 1; seed <= TORSIO_GENERATED_ORGANS; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    OrganFile organ;
    organ.mesh = requireOrgan(drawnTube(seed), "drawn");
    organ.anatomy =
        std::array{"stomach", "", "sigmoid", "intestine", "", "gastric-mesentero-axial"}[seed % 6];
    const FittedOrgan fitted = fitOrgan(organ, kAssets);
    if (fitted.refused()) {
      ASSERT_FALSE(fitted.judgement.findings.empty());
      continue;
    }
    ++accepted;
    organ.ends = fitted.ends;
    organ.patterns = acceptedAmong(fitted.patterns);
    ASSERT_FALSE(organ.patterns.empty());
    for (const std::string& pattern : organ.patterns) {
      SCOPED_TRACE(organ.anatomy + ' ' + pattern);
      ++patterns;
      const Scene scene = sceneOf(organ, pattern);
      if (scene.hollow) {
        ++twisted;
        expectWholeAsItComes(scene);
        expectUntwisted(scene);
        continue;
      }
      expectWhole(scene);
      if (pattern == organ.patterns[seed % organ.patterns.size()]) {
        expectTurned(scene);
        expectEndsTurn(scene);
      }
    }
  }
  RecordProperty("accepted", accepted);
  RecordProperty("patterns", patterns);
  RecordProperty("twisted", twisted);
  EXPECT_GT(accepted, TORSIO_GENERATED_ORGANS / 2);
}

}  // namespace
}  // namespace torsio
