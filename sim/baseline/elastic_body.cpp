// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/elastic_body.h"

#include <cmath>

#include "sim/base/portable_math.h"
#include "sim/base/refusal.h"

namespace torsio {

void checkElasticConstants(const ElasticConstants& constants) {
  if (!std::isfinite(constants.shearModulus_Pa) || constants.shearModulus_Pa <= 0.0) {
    refuseParameter(Text::tr("The shear modulus must be positive and finite"), Text::tr("shear modulus"),
                    Text::tr("Give it in pascal"));
  }
  if (!(constants.poissonRatio >= 0.0 && constants.poissonRatio < 0.5)) {
    refuseParameter(Text::tr("Poisson's ratio must lie in [0, 0.5)"), Text::tr("Poisson's ratio"),
                    Text::tr("Give a number such as 0.45; 0.5 itself has no finite stiffness"));
  }
}

TwistEnds twistEnds(const SweptSolid& solid) {
  TwistEnds ends;
  const int perSection = solid.pointsPerSection();
  const int last = (solid.sections - 1) * perSection;
  for (int i = 0; i < perSection; ++i) {
    ends.held.push_back(i);
    ends.turned.push_back(last + i);
  }
  ends.axisPoint_m = solid.endCentre_m;
  ends.axis = solid.endTangent;
  return ends;
}

void turnEnd(const TwistEnds& ends, std::span<const Vec3> rest_m, double angle_rad, TwistPose& pose) {
  const SinCos turn = portableSinCos(angle_rad);
  for (const int node : ends.turned) {
    const auto i = static_cast<std::size_t>(node);
    const Vec3 arm = rest_m[i] - ends.axisPoint_m;
    const Vec3 along = dot(arm, ends.axis) * ends.axis;
    pose.places_m[i] = ends.axisPoint_m + along + turn.cos * (arm - along) + turn.sin * cross(ends.axis, arm);
  }
  pose.angle_rad = angle_rad;
}

}  // namespace torsio
