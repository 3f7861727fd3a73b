// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/pattern_axes.h"

#include <algorithm>

namespace torsio {

namespace {

constexpr double kStraight = 0.01;  // of the length: an axis that bends less has no inside

/// Radius of the section's extent in a direction of its plane.
double reach_m(const SectionLattice& lattice, int j, const AxisFrame& frame, const Vec3& direction) {
  double most = 0.0;
  for (const Point2& p : lattice.outline_m(j)) {
    most = std::max(most, p[0] * dot(direction, frame.e1) + p[1] * dot(direction, frame.e2));
  }
  return most;
}

void throughEnds(TurnTask& task, const SectionLattice& lattice) {
  task.axisFrom_m = lattice.frameAt(0.0).centre_m;
  task.axisTo_m = lattice.frameAt(lattice.length_m()).centre_m;
}

void acrossBend(TurnTask& task, const SectionLattice& lattice) {
  const int j = lattice.sections() / 2;
  const AxisFrame middle = lattice.frameAt(lattice.sectionArc_m(j));
  const Vec3 chord = 0.5 * (lattice.frameAt(0.0).centre_m + lattice.frameAt(lattice.length_m()).centre_m);
  const Vec3 towards = chord - middle.centre_m;
  const Vec3 across = towards - dot(towards, middle.tangent) * middle.tangent;
  const Vec3 inside = norm(across) > kStraight * lattice.length_m() ? normalized(across) : middle.e1;
  task.axisFrom_m = middle.centre_m + reach_m(lattice, j, middle, inside) * inside;
  task.axisTo_m = middle.centre_m - reach_m(lattice, j, middle, -inside) * inside;
}

}  // namespace

TwistPattern patternFor(const SectionLattice& lattice, const PatternDescription& description) {
  TwistPattern pattern = description.pattern;
  if (!pattern.task) {
    return pattern;
  }
  pattern.task->measured.reset();
  if (pattern.task->axis == GripAxis::kLine) {
    description.elsewhere == AxisElsewhere::kEnds ? throughEnds(*pattern.task, lattice)
                                                  : acrossBend(*pattern.task, lattice);
  }
  return pattern;
}

}  // namespace torsio
