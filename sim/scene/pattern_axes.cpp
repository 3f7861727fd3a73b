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

void throughEnds(TwistOperation& operation, const SectionLattice& lattice) {
  operation.axisFrom_m = lattice.frameAt(0.0).centre_m;
  operation.axisTo_m = lattice.frameAt(lattice.length_m()).centre_m;
  if (operation.coordinate != TwistCoordinate::kAlongAxis) {
    return;
  }
  operation.from = 0.0;
  operation.to = 1.0;
  if (operation.peak) {
    operation.peak = std::clamp(*operation.peak, 0.1, 0.9);
  }
}

void acrossBend(TwistOperation& operation, const SectionLattice& lattice) {
  const int j = lattice.sections() / 2;
  const AxisFrame middle = lattice.frameAt(lattice.sectionArc_m(j));
  const Vec3 chord = 0.5 * (lattice.frameAt(0.0).centre_m + lattice.frameAt(lattice.length_m()).centre_m);
  const Vec3 towards = chord - middle.centre_m;
  const Vec3 across = towards - dot(towards, middle.tangent) * middle.tangent;
  const Vec3 inside = norm(across) > kStraight * lattice.length_m() ? normalized(across) : middle.e1;
  operation.axisFrom_m = middle.centre_m + reach_m(lattice, j, middle, inside) * inside;
  operation.axisTo_m = middle.centre_m - reach_m(lattice, j, middle, -inside) * inside;
}

}  // namespace

TwistPattern patternFor(const SectionLattice& lattice, const PatternDescription& description) {
  TwistPattern pattern = description.pattern;
  for (std::size_t i = 0; i < pattern.operations.size(); ++i) {
    TwistOperation& operation = pattern.operations[i];
    if (operation.axis != TwistAxis::kStraight) {
      continue;
    }
    if (description.elsewhere[i] == AxisElsewhere::kEnds) {
      throughEnds(operation, lattice);
    } else {
      acrossBend(operation, lattice);
    }
  }
  return pattern;
}

}  // namespace torsio
