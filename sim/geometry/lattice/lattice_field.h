// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/geometry/lattice/end_caps.h"
#include "sim/geometry/lattice/harmonic_field.h"
#include "sim/geometry/lattice/level_loops.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/geometry/lattice/section_outline.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// The surface with its two coordinates and its axis: what SectionLattice is read from. Not changed after
/// buildLatticeField.
struct LatticeField {
  TriangleMesh mesh;
  SurfaceTopology topology;
  LatticeMode mode = LatticeMode::kHarmonic;  ///< as built, never kAutomatic
  std::vector<LatticePart> parts;
  HarmonicField harmonic;
  Centreline centreline;
  RidgeRule rule;
  /// Levels of the traced stations, 0 to 1, ascending, and the arc length of each, never decreasing.
  std::vector<double> stationLevels;
  std::vector<double> stationArcs_m;
  /// With kArcLength: wayAtAngles of each station, kWaySteps + 1 entries a station.
  std::vector<std::vector<double>> stationWays;
  /// With kArcLength: shareOfWay of ridge 0 at each station, without jumps of a whole turn.
  std::vector<double> stationStarts;

  explicit LatticeField(const TriangleMesh& surface) : mesh(surface), topology(mesh) {}

  [[nodiscard]] double arcAtLevel_m(double level) const;
  [[nodiscard]] double levelAtArc(double arc_m) const;
  /// Returns the ridge angle of a point with the given harmonic coordinates (kArcLength), [0, 2 pi).
  [[nodiscard]] double ridgeAngle_rad(double level, double angle_rad) const;
  /// Returns the loop of the section at an arc length. Throws Error{kBadMesh} unless the section is one
  /// loop.
  [[nodiscard]] LevelLoop loopAt(double arc_m, const std::string& name) const;
};

/// Returns the loop that runs once about the organ. Loops about specks of rounding noise are ignored;
/// throws Error{kBadMesh} when there is no loop or a further one, naming the section and what to do in that
/// mode.
LevelLoop theOneLoop(std::vector<LevelLoop> loops, LatticeMode mode, const std::string& name);

/// Returns the loop about the organ where no section of the lattice lies: with parallel planes the longest
/// one, because a plane may cut off a bump there; else theOneLoop.
LevelLoop organLoop(std::vector<LevelLoop> loops, LatticeMode mode, const std::string& name);

/// Names a place on the organ: "the section 16.7 mm from the fixed end".
[[nodiscard]] std::string placeName(double arc_m);

/// Names a section: "section 3 of 25 (16.7 mm from the fixed end)"; j counts from 0.
[[nodiscard]] std::string sectionName(int j, int sections, double arc_m);

/// Builds caps or end planes, field, axis and ridge rule of an organ.
[[nodiscard]] LatticeField buildLatticeField(const TriangleMesh& mesh, const LatticeOptions& options);

}  // namespace torsio
