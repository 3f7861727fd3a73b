// SPDX-License-Identifier: GPL-3.0-or-later
// How the organ of a scene lies: by the twist model, as a rod, or as a hollow organ that came twisted.
#include <algorithm>
#include <cmath>

#include "sim/core/angle.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_view.h"
#include "sim/scene/rod_organ.h"
#include "sim/scene/scene.h"
#include "sim/tissue/twist/twist_model_tables.h"

namespace torsio {

namespace {

/// Returns the shear stress of a patch of an organ that is hollow or a rod.
double shearAt_Pa(const Scene& scene, std::size_t patch, const OrganState& state) noexcept {
  const double arc_m = scene.model.tables().patchArc_m[patch];
  const double byTwist_Pa_m = scene.model.tables().patchShear_Pa_m[patch];
  if (scene.hollow) {
    return scene.hollow->wallShear_Pa(arc_m, state) +
           byTwist_Pa_m * scene.hollow->cordTwist_rad_per_m(arc_m, state);
  }
  return byTwist_Pa_m * std::abs(scene.rod->twistRateAt(arc_m, state.pose));
}

}  // namespace

Vec3 Scene::toDeformed_m(const Vec3& rest_m, const OrganState& state) const noexcept {
  if (hollow && hollow->swing() != nullptr) {
    return hollow->swing()->rod().skin().toDeformed_m(rest_m, hollow->curveOf(state));
  }
  if (hollow) {
    return HollowMap(lattice(), *hollow, state).forward(rest_m);
  }
  if (!rod) {
    return model.toDeformed_m(rest_m, state.twist);
  }
  return state.pose.count == 0 ? rest_m : rod->skin().toDeformed_m(rest_m, rod->skin().curveOf(state.pose));
}

void Scene::deform(const OrganState& state, std::span<Vec3> out_m) const noexcept {
  if (hollow && hollow->swing() != nullptr) {
    hollow->swing()->rod().skin().deform(hollow->curveOf(state), out_m);
  } else if (hollow) {
    const HollowSkin skin(*hollow, state);
    const std::vector<TwistVertex>& vertices = hollow->vertices();
    const auto places = lattice().vertexCoordinates();
    for (std::size_t i = 0; i < out_m.size() && i < vertices.size(); ++i) {
      out_m[i] = skin.vertex(vertices[i], places[i].angle_rad);
    }
  } else if (!rod) {
    model.deform(state.twist, out_m);
  } else if (state.pose.count == 0) {
    std::copy_n(mesh.vertices_m.begin(), std::min(out_m.size(), mesh.vertices_m.size()), out_m.begin());
  } else {
    rod->skin().deform(rod->skin().curveOf(state.pose), out_m);
  }
}

void Scene::patchShear(const OrganState& state, std::span<double> out_Pa) const noexcept {
  if (!hollow && !rod) {
    model.patchShear(state.twist, out_Pa);
    return;
  }
  for (std::size_t i = 0; i < out_Pa.size() && i < model.tables().patchArc_m.size(); ++i) {
    out_Pa[i] = shearAt_Pa(*this, i, state);
  }
}

double Scene::peakShear_Pa(const OrganState& state) const noexcept {
  if (!hollow && !rod) {
    return model.peakShear_Pa(state.twist);
  }
  double peak_Pa = 0.0;
  for (std::size_t i = 0; i < model.tables().patchArc_m.size(); ++i) {
    peak_Pa = std::max(peak_Pa, shearAt_Pa(*this, i, state));
  }
  return peak_Pa;
}

AxisFrame Scene::graspFrame(double arc_m, const Vec3& hand_m) const noexcept {
  if (hollow) {
    return hollow->graspFrame(hand_m);
  }
  return rod ? rod->grip(rod->rod().rest(), arc_m, {hand_m, {}}).axis : model.graspFrame(arc_m);
}

double Scene::grasp_m() const noexcept {
  return std::clamp(pattern.graspArc, 0.0, 1.0) * lattice().length_m();
}

OrganState Scene::stateAt(double angle_rad) const {
  if (hollow) {
    return hollow->stateAt(angle_rad);
  }
  if (!rod) {
    return {{grasp_m(), angle_rad}, {}};
  }
  const TaskPoint point = atAngle(rod->path(), angle_rad);
  return {{grasp_m(), point.angle_rad}, point.angle_rad == 0.0 ? RodPose{} : point.pose};
}

double Scene::torqueAt_Nm(double angle_rad) const {
  if (hollow) {
    return hollow->torque_Nm(angle_rad, hollow->detorsion().wall.pressure_Pa);
  }
  return rod ? atAngle(rod->path(), angle_rad).torque_Nm : model.torque_Nm({grasp_m(), angle_rad});
}

OrganState Scene::stateForTorque(double torque_Nm) const {
  if (hollow) {
    constexpr double kStep_rad = radians(1.0);
    const double most_rad = pattern.detorsion->start.most_rad;
    double angle_rad = 0.0;
    while (angle_rad < most_rad && std::abs(torqueAt_Nm(angle_rad)) < std::abs(torque_Nm)) {
      angle_rad += kStep_rad;
    }
    return stateAt(torque_Nm < 0.0 ? -angle_rad : angle_rad);
  }
  if (!rod) {
    return {model.stateForTorque(grasp_m(), torque_Nm), {}};
  }
  double angle_rad = 0.0;
  for (const TaskPoint& point : rod->path()) {
    angle_rad = point.angle_rad;
    if (std::abs(point.torque_Nm) >= std::abs(torque_Nm)) {
      break;
    }
  }
  return stateAt(angle_rad);
}

}  // namespace torsio
