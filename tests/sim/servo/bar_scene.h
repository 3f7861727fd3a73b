// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/angle.h"
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

}  // namespace torsio
