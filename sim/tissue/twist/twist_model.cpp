// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/tissue/twist/twist_model_map.h"
#include "sim/tissue/twist/twist_model_tables.h"

namespace torsio {

namespace {

constexpr int kTorqueSteps = 60;
constexpr double kDeterminantProbe = 1e-5;  // of the organ's length
constexpr double kSmallestArm = 1e-9;       // m

// det of the map at a point, from the movement of its six neighbours.
double determinantAt(const TwistModel& model, const TwistState& state, const Vec3& point, double probe_m) {
  const auto column = [&](const Vec3& way) {
    return model.toDeformed_m(point + way, state) - model.toDeformed_m(point - way, state);
  };
  const Vec3 a = column({probe_m, 0.0, 0.0});
  const Vec3 b = column({0.0, probe_m, 0.0});
  const Vec3 c = column({0.0, 0.0, probe_m});
  return dot(a, cross(b, c)) / (8.0 * probe_m * probe_m * probe_m);
}

double linearStiffness(const TwistModel::Tables& tables, double graspArc_m) {
  return 1.0 / tables.twist.compliance(graspArc_m);
}

struct Load {
  double torque_Nm = 0.0;
  double stiffness_Nm = 0.0;  // tangent: d torque / d angle
};

Load loadOf(const TwistModel::Tables& tables, const TwistState& state) {
  const double stiffness = linearStiffness(tables, state.graspArc_m);
  const double torque = stiffness * state.graspAngle_rad;
  if (!(tables.stiffeningStrain > 0.0)) {
    return {torque, stiffness};
  }
  const double strain = torque * tables.strainPerTorque.value(state.graspArc_m) / tables.stiffeningStrain;
  const double more = strain * strain;
  return {torque * (1.0 + more), stiffness * (1.0 + 3.0 * more)};
}

// The paper's Eq. 15: displacement components kriged along the ridge, straight across to the next ridge.
void deformByComponents(const TwistModel::Tables& tables, const SectionLattice& lattice,
                        const TwistState& state, std::span<Vec3> out_m) {
  const int n = lattice.ridges();
  const int m = lattice.sections();
  const TwistMap map(tables, lattice, state);
  const double grasp = tables.twist.graspAt(state.graspArc_m);
  const double torque = state.graspAngle_rad / tables.twist.compliance(grasp);
  std::array<double, kMaxSections> angle{};
  std::array<double, kMaxSections> lifted{};
  for (int j = 0; j < m; ++j) {
    const double arc = lattice.length_m() * j / (m - 1);
    angle[static_cast<std::size_t>(j)] = map.angle(arc);
    lifted[static_cast<std::size_t>(j)] = arc <= grasp ? torque : 0.0;
  }
  for (std::size_t v = 0; v < out_m.size(); ++v) {
    const RidgePlace& place = tables.ridgePlaces[v];
    const int next = place.ridge + 1 < n ? place.ridge + 1 : 0;
    const std::size_t first = static_cast<std::size_t>(tables.alongRidge->first()[v]);
    const std::span<const double> lambda = tables.alongRidge->row(static_cast<int>(v));
    Vec3 sum;
    for (std::size_t i = 0; i < lambda.size(); ++i) {
      const std::size_t j = first + i;
      const std::size_t here = j * static_cast<std::size_t>(n) + static_cast<std::size_t>(place.ridge);
      const std::size_t there = j * static_cast<std::size_t>(n) + static_cast<std::size_t>(next);
      const Vec3 a = angle[j] * tables.keyTurn_m[here] + lifted[j] * tables.keyLift_m[here];
      const Vec3 b = angle[j] * tables.keyTurn_m[there] + lifted[j] * tables.keyLift_m[there];
      sum += lambda[i] * (a + place.share * (b - a));
    }
    out_m[v] = tables.vertices[v].rest_m + sum;
  }
}

}  // namespace

TwistModel::TwistModel(const TriangleMesh& mesh, const SectionLattice& lattice, const Material& material,
                       const TwistModelOptions& options)
    : options_(options),
      lattice_(lattice),
      material_(material),
      tables_(std::make_shared<const Tables>(makeTwistTables(mesh, lattice, material, options))) {}

double TwistModel::graspCompliance(double graspArc_m) const noexcept {
  return 1.0 / linearStiffness(*tables_, graspArc_m);
}

double TwistModel::torque_Nm(const TwistState& state) const noexcept {
  return loadOf(*tables_, state).torque_Nm;
}

TwistState TwistModel::stateForTorque(double graspArc_m, double torque_Nm) const {
  if (!std::isfinite(torque_Nm) || !std::isfinite(graspArc_m)) {
    throw Error(ErrorCode::kBadParameter,
                Text::verbatim("the torque %1 N m at arc length %2 m is not finite",
                               std::to_string(torque_Nm), std::to_string(graspArc_m)),
                Text::verbatim("twist"), Text::tr("Give finite numbers."));
  }
  TwistState state{graspArc_m, torque_Nm / linearStiffness(*tables_, graspArc_m)};
  // Newton from above on a rising, convex curve; linear tissue is there at once.
  for (int i = 0; i < kTorqueSteps; ++i) {
    const Load load = loadOf(*tables_, state);
    const double step = (load.torque_Nm - torque_Nm) / load.stiffness_Nm;
    if (step == 0.0) {
      break;
    }
    state.graspAngle_rad -= step;
  }
  return state;
}

double TwistModel::angleAt(double arc_m, const TwistState& state) const noexcept {
  return TwistMap(*tables_, lattice_, state).angle(arc_m);
}

double TwistModel::twistRateAt(double arc_m, const TwistState& state) const noexcept {
  return TwistMap(*tables_, lattice_, state).rate(arc_m);
}

AxisFrame TwistModel::graspFrame(double graspArc_m) const noexcept {
  AxisFrame frame = lattice_.frameAt(graspArc_m);
  if (tables_->shiftedCentre) {
    frame.centre_m +=
        tables_->centreX.value(graspArc_m) * frame.e1 + tables_->centreY.value(graspArc_m) * frame.e2;
  }
  return frame;
}

Vec3 TwistModel::graspForce_N(const TwistState& state, const Vec3& grip_m) const noexcept {
  if (state.graspAngle_rad == 0.0) {
    return {};
  }
  const Load load = loadOf(*tables_, state);
  const AxisFrame frame = graspFrame(state.graspArc_m);
  const Vec3 way = cross(frame.tangent, grip_m - frame.centre_m);  // of the grip for one radian
  const double arm2 = dot(way, way);
  if (!(arm2 > kSmallestArm * kSmallestArm)) {
    return {};
  }
  const double cap = options_.stiffnessCap_N_per_m;
  return (-load.torque_Nm / std::max(arm2, load.stiffness_Nm / cap)) * way;
}

Vec3 TwistModel::toRest_m(const Vec3& deformed_m, const TwistState& state) const noexcept {
  return TwistMap(*tables_, lattice_, state).backward(deformed_m);
}

Vec3 TwistModel::toDeformed_m(const Vec3& rest_m, const TwistState& state) const noexcept {
  const TwistMap map(*tables_, lattice_, state);
  if (map.identity()) {
    return rest_m;
  }
  return map.forward(rest_m, tables_->arcs.arcAt(lattice_, rest_m));
}

bool TwistModel::knowsWays() const noexcept {
  return tables_->reach.bounded;
}

// A vertex turns about its line by at most the grasp's angle: a chord. Warping goes along that line.
double TwistModel::farthestWay_m(const TwistState& from, const TwistState& to) const noexcept {
  const Tables::Reach& reach = tables_->reach;
  const auto perRadian_m = [&](double graspArc_m) {
    const TorsionTable::Place grasp = tables_->twist.placeAt(tables_->twist.graspAt(graspArc_m));
    const double slope =
        std::max(reach.risingSlope / grasp.rising.value, reach.fallingSlope / grasp.falling.value);
    return reach.radius_m + reach.warp_m2 * slope;
  };
  if (from.graspArc_m == to.graspArc_m) {
    const double turned_rad = std::abs(to.graspAngle_rad - from.graspAngle_rad);
    return turned_rad == 0.0 ? 0.0
           : reach.bounded   ? turned_rad * perRadian_m(to.graspArc_m)
                             : std::numeric_limits<double>::infinity();
  }
  const TwistState before{from.graspArc_m, 0.0};
  const TwistState after{to.graspArc_m, 0.0};
  return farthestWay_m(from, before) + farthestWay_m(after, to);  // by way of rest
}

void TwistModel::deform(const TwistState& state, std::span<Vec3> out_m) const noexcept {
  const std::size_t count = std::min(out_m.size(), tables_->vertices.size());
  if (tables_->components && state.graspAngle_rad != 0.0) {
    deformByComponents(*tables_, lattice_, state, out_m.first(count));
    return;
  }
  const TwistMap map(*tables_, lattice_, state);
  for (std::size_t v = 0; v < count; ++v) {
    out_m[v] = map.vertex(tables_->vertices[v]);
  }
}

void TwistModel::patchShear(const TwistState& state, std::span<double> out_Pa) const noexcept {
  const TwistMap map(*tables_, lattice_, state);
  const std::size_t count = std::min(out_Pa.size(), tables_->patchArc_m.size());
  double arc = -1.0;
  double rate = 0.0;
  for (std::size_t p = 0; p < count; ++p) {
    if (tables_->patchArc_m[p] != arc) {  // a row of patches shares its arc length
      arc = tables_->patchArc_m[p];
      rate = std::abs(map.rate(arc));
    }
    out_Pa[p] = rate * tables_->patchShear_Pa_m[p];
  }
}

double TwistModel::peakShear_Pa(const TwistState& state) const noexcept {
  const double torque = linearStiffness(*tables_, state.graspArc_m) * std::abs(state.graspAngle_rad);
  return material_.shearModulus_Pa * torque * tables_->strainPerTorque.value(state.graspArc_m);
}

TwistSummary TwistModel::summary(const TwistState& state) const {
  TwistSummary s;
  s.torque_Nm = torque_Nm(state);
  s.peakShear_Pa = peakShear_Pa(state);
  s.peakShearStrain = s.peakShear_Pa / material_.shearModulus_Pa;
  std::vector<Vec3> deformed(tables_->vertices.size());
  deform(state, deformed);
  for (std::size_t v = 0; v < deformed.size(); ++v) {
    s.maxDisplacement_m = std::max(s.maxDisplacement_m, norm(deformed[v] - tables_->vertices[v].rest_m));
  }
  const TwistMap map(*tables_, lattice_, state);
  const double probe = kDeterminantProbe * lattice_.length_m();
  for (int j = 0; j + 1 < lattice_.sections(); ++j) {
    const double arc = 0.5 * (lattice_.sectionArc_m(j) + lattice_.sectionArc_m(j + 1));
    for (int k = 0; k < lattice_.ridges(); ++k) {
      const Vec3 key = 0.5 * (lattice_.keyPoint_m(k, j) + lattice_.keyPoint_m(k, j + 1));
      s.maxRadiusGrowth = std::max(s.maxRadiusGrowth, map.radiusGrowth(key, arc));
      if (map.identity()) {
        continue;
      }
      const double determinant = determinantAt(*this, state, key, probe);
      const bool first = j == 0 && k == 0;
      s.minDeterminant = first ? determinant : std::min(s.minDeterminant, determinant);
      s.maxDeterminant = first ? determinant : std::max(s.maxDeterminant, determinant);
    }
  }
  return s;
}

}  // namespace torsio
