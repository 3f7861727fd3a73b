// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "sim/core/portable_math.h"
#include "sim/tissue/twist/twist_model.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {

// A forearm-sized bar: solid, G = 5 kPa, radius 40 mm, length 250 mm.
inline constexpr double kBarRadius_m = 0.040;
inline constexpr double kBarLength_m = 0.250;
inline constexpr double kBarShear_Pa = 5000.0;
inline constexpr int kBarPoints = 100;
/// J of the regular 100-gon over that of its circle: conformal map, table of closed forms in docs/model.md.
inline constexpr double kGon100 = 0.998675;

inline Material barMaterial() {
  Material material;
  material.id = "test";
  material.shearModulus_Pa = kBarShear_Pa;
  return material;
}

inline LatticeOptions straightLattice(int sections = 26, int ridges = 24) {
  return {.ridges = ridges,
          .sections = sections,
          .mode = LatticeMode::kStraightAxis,
          .fixedEnd_m = {0.0, 0.0, 0.0},
          .freeEnd_m = {0.0, 0.0, kBarLength_m},
          .ridgeZero = {1.0, 0.0, 0.0}};
}

/// Membrane problems of a test bar: its sections are scaled copies of one another, so that a few say it all.
inline TwistModelOptions fewSections(TwistModelOptions options) {
  options.solvedSections = 7;
  return options;
}

/// A mesh with its model.
struct Bar {
  TriangleMesh mesh;
  TwistModel model;

  [[nodiscard]] double length_m() const { return model.lattice().length_m(); }
};

inline Bar straightBar(TriangleMesh mesh, const TwistModelOptions& options = {}, int sections = 26) {
  TwistModel model(mesh, SectionLattice(mesh, straightLattice(sections)), barMaterial(),
                   fewSections(options));
  return {std::move(mesh), std::move(model)};
}

inline Bar roundBar(const TwistModelOptions& options = {}, double topScale = 1.0, int sections = 26) {
  return straightBar(
      testing::prism(testing::circleOutline(kBarRadius_m, kBarPoints), kBarLength_m, 50, topScale), options,
      sections);
}

/// A section without any symmetry, radius 25 to 40 mm.
inline testing::Outline2 irregularOutline() {
  testing::Outline2 outline;
  for (int i = 0; i < kBarPoints; ++i) {
    const double a = 2.0 * kPi * i / kBarPoints;
    const double r =
        0.033 + 0.004 * std::cos(2.0 * a + 0.4) + 0.003 * std::sin(3.0 * a) + 0.001 * std::cos(5.0 * a);
    outline.push_back({r * std::cos(a), r * std::sin(a)});
  }
  return outline;
}

/// A bent tube of radius 30 mm about an arc of radius 90 mm (curvature times radius 1/3).
inline Bar bentBar(const TwistModelOptions& options = {}, double angle_rad = 2.5) {
  TriangleMesh mesh = testing::bentTube(0.030, 0.090, angle_rad, 64, 60);
  LatticeOptions lattice{
      .ridges = 24,
      .sections = 25,
      .fixedEnd_m = {0.0, 0.0, 0.0},
      .freeEnd_m = {0.090 * (1.0 - std::cos(angle_rad)), 0.0, 0.090 * std::sin(angle_rad)}};
  TwistModel model(mesh, SectionLattice(mesh, lattice), barMaterial(), fewSections(options));
  return {std::move(mesh), std::move(model)};
}

/// Distance from the z axis.
inline double axisDistance(const Vec3& p) {
  return std::sqrt(p.x * p.x + p.y * p.y);
}

}  // namespace torsio
