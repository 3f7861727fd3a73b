// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "sim/core/angle.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {

// A forearm of the twist table (section G of the model notes): solid, G = 5 kPa, radius 40 mm, length 250 mm.
inline constexpr double kBarRadius_m = 0.040;
inline constexpr double kBarLength_m = 0.250;
inline constexpr double kBarShear_Pa = 5000.0;
/// Torsional stiffness of the round bar for a grasp at `arc_m`: G pi r^4 / (2 s).
inline double barStiffness_Nm(double arc_m) {
  return kBarShear_Pa * 3.14159265358979323846 * kBarRadius_m * kBarRadius_m * kBarRadius_m * kBarRadius_m /
         (2.0 * arc_m);
}

/// A scene around an upright round bar that is fixed at z = 0.
inline Scene barScene(TriangleMesh mesh = testing::prism(testing::circleOutline(kBarRadius_m, 72),
                                                         kBarLength_m, 40)) {
  LatticeOptions lattice{.ridges = 24,
                         .sections = 13,
                         .mode = LatticeMode::kStraightAxis,
                         .fixedEnd_m = {0.0, 0.0, 0.0},
                         .freeEnd_m = {0.0, 0.0, kBarLength_m},
                         .ridgeZero = {1.0, 0.0, 0.0}};
  TwistPattern pattern;
  pattern.id = "quarter";
  pattern.graspArc = 0.8;
  pattern.targetAngle_rad = radians(90.0);
  Material material;
  material.id = "test";
  material.shearModulus_Pa = kBarShear_Pa;
  CollisionMesh collision(mesh);
  TwistModel model(mesh, SectionLattice(mesh, lattice), material, {});
  return Scene{.id = "bar",
               .title = "Straight bar",
               .provenance = "made by the test",
               .organHash = contentHash(mesh),
               .parameterHash = "bar-parameters",
               .parametersJson = "{}",
               .mesh = std::move(mesh),
               .collision = std::move(collision),
               .model = std::move(model),
               .instrument = {},
               .pattern = pattern,
               .patterns = {pattern}};
}

/// A tube of 40 mm radius and 3 mm wall that came twisted by 270 degrees: held at its foot, wrung over 140
/// mm, its upper part mobile. Relapse from 90 degrees on, a whole one lasts 3 s.
inline Detorsion twistedTube() {
  Detorsion detorsion;
  detorsion.wall = {.thickness_m = {{0.0, 0.003}},
                    .restPressure_Pa = 2.0 * kPascalsPerMmHg,
                    .pressure_Pa = 2.0 * kPascalsPerMmHg,
                    .vent = true,
                    .ventedPressure_Pa = 0.5 * kPascalsPerMmHg,
                    .source = "test"};
  detorsion.spans = {{0.0, 0.56}};
  detorsion.start = {.least_rad = radians(270.0), .most_rad = radians(270.0), .source = "test"};
  detorsion.base = {.stickShare = 0.5,
                    .relapseShare = 0.3,
                    .relapseFrom_rad = radians(90.0),
                    .relapseTime_s = 3.0,
                    .source = "test"};
  detorsion.limits.residual_rad = radians(15.0);
  detorsion.limits.jawForce_N = 6.0;
  detorsion.limits.jawArea_m2 = 20e-6;  // 300 kPa when closed: below a bruise
  detorsion.limits.source = "test";
  return detorsion;
}

/// A solid cord of 20 mN m/rad that came twisted by `turn_rad`; friction alone holds it.
inline Detorsion twistedCord(double turn_rad) {
  Detorsion detorsion = twistedTube();
  detorsion.wall = {};
  detorsion.cordStiffness_Nm_per_rad = 0.020;
  detorsion.start.least_rad = turn_rad;
  detorsion.start.most_rad = turn_rad;
  detorsion.base.relapseShare = 0.0;
  return detorsion;
}

/// The upright bar of barScene() as a hollow organ.
inline Scene hollowScene(const Detorsion& detorsion) {
  Scene scene = barScene();
  scene.id = "hollow-bar";
  scene.pattern.id = "detorse";
  scene.pattern.targetAngle_rad = 0.0;
  scene.pattern.detorsion = std::make_shared<const Detorsion>(detorsion);
  scene.patterns = {scene.pattern};
  scene.hollow =
      std::make_shared<const HollowOrgan>(HollowOrgan::Parts{.lattice = &scene.lattice(),
                                                             .shearModulus_Pa = kBarShear_Pa,
                                                             .graspArc = scene.pattern.graspArc,
                                                             .detorsion = detorsion,
                                                             .vertices_m = scene.mesh.vertices_m,
                                                             .patches = &scene.collision.patches()});
  return scene;
}

}  // namespace torsio
