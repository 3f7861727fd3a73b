// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/elastic_body.h"

#include <algorithm>
#include <cmath>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/tissue/rod/rod.h"

namespace torsio {

namespace {

/// The centres of a solid as a way from section to section.
class OrganSteps {
 public:
  explicit OrganSteps(const SweptSolid& solid) : solid_(solid) {
    for (int j = 0; j + 1 < solid.sections; ++j) {
      steps_.push_back({norm(solid.centre_m(j + 1) - solid.centre_m(j))});
      length_m_ += steps_.back().length_m;
    }
  }

  /// The sections within `halfWidth_m` of a fraction of the length, the nearest one at least.
  [[nodiscard]] NodeRange around(double fraction, double halfWidth_m) const {
    return nodesAround(steps_, fraction * length_m_, halfWidth_m, solid_.sections);
  }
  [[nodiscard]] double areaAt_m2(double fraction) const {
    const auto [section, share] = placeOf(fraction);
    return (1.0 - share) * sectionArea_m2(solid_, section) + share * sectionArea_m2(solid_, section + 1);
  }
  [[nodiscard]] Vec3 centreAt_m(double fraction) const {
    const auto [section, share] = placeOf(fraction);
    return (1.0 - share) * solid_.centre_m(section) + share * solid_.centre_m(section + 1);
  }
  [[nodiscard]] Vec3 tangentAt(double fraction) const {
    const auto [section, share] = placeOf(fraction);
    return normalized((1.0 - share) * sectionTangent(solid_, section) +
                      share * sectionTangent(solid_, section + 1));
  }

 private:
  struct Step {
    double length_m = 0.0;
  };
  struct Place {
    int section = 0;
    double share = 0.0;  ///< of the way to the next one
  };
  [[nodiscard]] Place placeOf(double fraction) const {
    double left_m = fraction * length_m_;
    std::size_t step = 0;
    while (step + 1 < steps_.size() && left_m > steps_[step].length_m * (1.0 + 1e-12)) {
      left_m -= steps_[step++].length_m;
    }
    return {static_cast<int>(step), std::min(1.0, left_m / steps_[step].length_m)};
  }

  const SweptSolid& solid_;
  std::vector<Step> steps_;
  double length_m_ = 0.0;
};

}  // namespace

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

TwistEnds twistEnds(const SweptSolid& solid, const TwistHold& hold) {
  const OrganSteps organ(solid);
  const auto& [begin, end] = hold.span;
  if (!(begin >= 0.0 && begin < end && end <= 1.0)) {
    refuseParameter(Text::verbatim("The part that deforms must lie in the organ"), Text::verbatim("span"),
                    Text::verbatim("Give two rising fractions of its length"));
  }
  if (hold.grasp && !(*hold.grasp > 0.0 && *hold.grasp <= 1.0)) {
    refuseParameter(Text::verbatim("The grasp must lie in (0, 1], as a fraction of the organ's length"),
                    Text::verbatim("grasp"), Text::verbatim("Give a fraction such as 0.5"));
  }
  TwistEnds ends;
  const int lastHeld = organ.around(begin, 0.0).first;
  NodeRange turned{organ.around(end, 0.0).first, solid.sections - 1};
  if (hold.grasp) {
    turned = organ.around(*hold.grasp, 0.5 * std::sqrt(organ.areaAt_m2(*hold.grasp) / kPi));
    ends.axisPoint_m = organ.centreAt_m(*hold.grasp);
    ends.axis = organ.tangentAt(*hold.grasp);
    ends.placeFree = true;
  } else {
    ends.axisPoint_m = solid.centre_m(turned.first);
    ends.axis = sectionTangent(solid, turned.first);
  }
  if (turned.first <= lastHeld) {
    refuseParameter(Text::verbatim("What is turned would reach the held end"), Text::verbatim("grasp"),
                    Text::verbatim("Grip further away from it, or give more sections"));
  }
  const int perSection = solid.pointsPerSection();
  for (int i = 0; i < (lastHeld + 1) * perSection; ++i) {
    ends.held.push_back(i);
  }
  for (int i = turned.first * perSection; i < (turned.last + 1) * perSection; ++i) {
    ends.turned.push_back(i);
  }
  return ends;
}

int freeUnknowns(const SweptSolid& solid, const TwistEnds& ends) noexcept {
  const auto bound = static_cast<int>(ends.held.size() + ends.turned.size());
  return 3 * (solid.pointsPerSection() * solid.sections - bound) + (ends.placeFree ? 4 : 1);
}

void turnEnd(const TwistEnds& ends, std::span<const Vec3> rest_m, double angle_rad, TwistPose& pose) {
  const SinCos turn = portableSinCos(angle_rad);
  for (const int node : ends.turned) {
    const auto i = static_cast<std::size_t>(node);
    const Vec3 arm = rest_m[i] - ends.axisPoint_m;
    const Vec3 along = dot(arm, ends.axis) * ends.axis;
    pose.places_m[i] =
        ends.axisPoint_m + pose.way_m + along + turn.cos * (arm - along) + turn.sin * cross(ends.axis, arm);
  }
  pose.angle_rad = angle_rad;
}

double criticalDrag_per_s(const ElasticConstants& constants, double density_kg_per_m3, double length_m) {
  return kPi * std::sqrt(constants.shearModulus_Pa / density_kg_per_m3) / length_m;
}

std::vector<double> nodeMasses(const SolidMesh& tetrahedra, std::span<const Vec3> rest_m,
                               double density_kg_per_m3) {
  std::vector<double> masses(rest_m.size());
  const std::vector<double> volumes_m3 = tetrahedronVolumes(tetrahedra, rest_m);
  for (std::size_t c = 0; c < tetrahedra.cells(); ++c) {
    for (const int node : tetrahedra.cell(c)) {
      masses[static_cast<std::size_t>(node)] += 0.25 * density_kg_per_m3 * volumes_m3[c];
    }
  }
  return masses;
}

double endInertia(const TwistEnds& ends, std::span<const Vec3> rest_m, std::span<const double> masses_kg) {
  double inertia = 0.0;
  for (const int node : ends.turned) {
    const auto i = static_cast<std::size_t>(node);
    const Vec3 motion = cross(ends.axis, rest_m[i] - ends.axisPoint_m);
    inertia += masses_kg[i] * dot(motion, motion);
  }
  return inertia;
}

}  // namespace torsio
