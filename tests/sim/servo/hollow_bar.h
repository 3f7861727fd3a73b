// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "sim/scene/hollow_organ.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {

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
