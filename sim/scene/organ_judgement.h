// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sim/geometry/lattice/section_lattice.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/scene/organ_finding.h"

namespace torsio {

/// Most triangles of the surface that is measured: the time of a lattice grows faster than its
/// mesh.
inline constexpr std::size_t kJudgedTriangles = 100'000;

/// Limits of what the lattice of ridges and sections can describe; docs/organs.md says what organs measure.
struct OrganLimits {
  double leastElongation = 1.75;  ///< length over largest mean width; below: refused
  double usualElongation = 2.2;   ///< below: a warning
  double mostFlatness = 4.0;      ///< long over short side of the sections; above: refused
  double usualFlatness = 2.5;     ///< above: a warning
  double usualOverlap = 0.0;      ///< share of the organ where sections run into each other; above: a warning
  double mostBranch = 0.12;       ///< share of the surface that stands off its section; above: refused
  double usualBranch = 0.03;      ///< above: a warning
  double mostBeyond = 0.45;       ///< share of the surface beyond ends that are not cut; above: refused
  double usualBeyond = 0.2;       ///< above: a warning
  double usualWidthRatio = 3.0;   ///< widest over narrowest, middle four fifths; above: a warning
  double mostCrossingShare = 1e-3;  ///< of the triangles that cross others at rest; refused
  double mostStalkWidth = 0.6;      ///< of a stalk over what it carries; above: refused
};

/// Measures of an organ as the lattice sees it; of one on a stalk those of the stalk, but for its length.
struct OrganMeasures {
  double length_m = 0.0;    ///< of the whole organ
  double widest_m = 0.0;    ///< diameter of the round section of the same area
  double elongation = 0.0;  ///< length of what is wrung over widest
  double flatness = 1.0;    ///< long over short side, median over the sections
  double overlap = 0.0;     ///< share of the places on the sections that run into the next one
  double branch = 0.0;      ///< share of the surface farther off its section than its radius
  double beyond = 0.0;      ///< share of the surface beyond ends that are not cut
  double widthRatio = 1.0;  ///< widest over narrowest, middle four fifths
  double widestAt = 0.0;    ///< place of the widest of those sections, share of the length from the fixed end
  double narrowestAt = 0.0;  ///< place of the narrowest of them
  double caps = 0.0;         ///< share of the surface that belongs to an end, not to a section
  std::size_t crossingsAtRest = 0;
  double stalkWidth = 0.0;  ///< median width of the stalk over the widest of what it carries; 0: no stalk
};

/// What the lattice makes of an organ.
struct OrganJudgement {
  OrganMeasures measures;              ///< zero where there is no lattice
  std::vector<OrganFinding> findings;  ///< in the order of the codes; none: a good organ
  /// Tells whether the organ has no lattice at all.
  [[nodiscard]] bool shapeless() const noexcept { return measures.length_m == 0.0; }
};

/// Judges the shape of an organ: builds its lattice and measures it; what its patterns do to it,
/// judgePatterns() says. A surface of more than kJudgedTriangles is thinned to so many for that. `whole`: of
/// requireOrgan. A mesh without a lattice is refused with what the lattice says. `wrung`: share of the
/// length, from the fixed end, that is wrung: below 1 a stalk, which alone is measured, while the rest turns
/// on it as a whole.
[[nodiscard]] OrganJudgement judgeOrgan(const TriangleMesh& whole, const LatticeOptions& options,
                                        double wrung = 1.0, const OrganLimits& limits = {});

}  // namespace torsio
