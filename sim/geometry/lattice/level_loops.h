// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/lattice/harmonic_field.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Where a level line crosses an edge of the mesh.
struct LoopPoint {
  Vec3 position_m;
  std::uint32_t half = 0;  ///< half-edge of the triangle in which the line goes on
  double share = 0.0;      ///< way along that half-edge, 0..1
  double angle_rad = 0.0;  ///< harmonic angle, continuous along the loop
  double way_m = 0.0;      ///< length of the loop from its first point
};

/// A closed level line, anticlockwise about the direction from the fixed to the free end.
struct LevelLoop {
  std::vector<LoopPoint> points;  ///< first point not repeated
  double perimeter_m = 0.0;
  double turn_rad = 0.0;  ///< rise of the angle once around: 2 pi about the organ, 0 about a bump
  Vec3 areaVector_m2;     ///< points along the organ; its length is the area of a flat loop
  Vec3 centroid_m;        ///< of the area (flat loops exactly, others seen along the area vector)
};

/// Traces level lines of a scalar field on the surface.
class LevelTracer {
 public:
  /// Makes a tracer; mesh, topology and field outlive it. `field.level` has one finite value a vertex.
  LevelTracer(const TriangleMesh& mesh, const SurfaceTopology& topology, const HarmonicField& field);

  /// Traces all loops of one level, longest first. `fromBelow`: vertices on the level count as above it
  /// (for the free end), else as below.
  [[nodiscard]] std::vector<LevelLoop> trace(double level, bool fromBelow = false) const;

  /// Traces many ascending levels and passes the loops of each to `use` with the index of the level; much
  /// faster than one trace a level. Vertices on the last level count as above it.
  void traceAll(std::span<const double> levels,
                const std::function<void(std::size_t, std::vector<LevelLoop>)>& use) const;

 private:
  [[nodiscard]] std::vector<LevelLoop> traceIn(std::span<const std::uint32_t> crossed, double level,
                                               bool fromBelow) const;
  [[nodiscard]] LevelLoop walk(std::uint32_t start, double level, bool fromBelow) const;

  const TriangleMesh& mesh_;
  const SurfaceTopology& topology_;
  const HarmonicField& field_;
  mutable std::vector<std::uint32_t> visited_;  // mark of the trace that saw a triangle last
  mutable std::uint32_t mark_ = 0;
};

}  // namespace torsio
