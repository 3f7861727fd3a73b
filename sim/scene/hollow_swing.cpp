// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_swing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/scene/pattern_judgement.h"

namespace torsio {

namespace {

constexpr double kBeyond_rad = radians(15.0);
constexpr double kLeastStep_rad = radians(0.1);  // between two points of a path

}  // namespace

HollowSwing::HollowSwing(std::shared_ptr<const RodOrgan> rod, double graspArc, double most_rad)
    : rod_(std::move(rod)) {
  std::vector<TaskPoint> points;
  for (const double way : {-1.0, 1.0}) {
    TurnEnd end = TurnEnd::kThere;
    const std::vector<TaskPoint> path = rod_->follow(graspArc, way * (most_rad + kBeyond_rad), false, &end);
    if (!reaches(path, way * most_rad)) {
      refuseParameter(turnEndsAt(path.back().angle_rad, end), Text::tr("field 'most_deg'"),
                      Text::tr("Twist less far."));
    }
    for (const TaskPoint& point : path) {
      if (points.empty() || way * point.angle_rad > way * points.back().angle_rad + kLeastStep_rad) {
        points.push_back(point);
      }
    }
    if (way < 0.0) {
      std::reverse(points.begin(), points.end());
    }
  }
  for (const TaskPoint& point : points) {
    angles_rad_.push_back(point.angle_rad);
    poses_.push_back(point.pose);
    loads_.push_back({point.torque_Nm, point.twist_rad, {}});
  }
  for (std::size_t i = 0; i < loads_.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, loads_.size() - 1);
    for (std::size_t k = 0; k < loads_[i].twistRate.size(); ++k) {
      loads_[i].twistRate[k] = (loads_[after].twist_rad[k] - loads_[before].twist_rad[k]) /
                               (angles_rad_[after] - angles_rad_[before]);
    }
  }
}

double HollowSwing::within_rad(double angle_rad) const noexcept {
  return std::clamp(angle_rad, angles_rad_.front(), angles_rad_.back());
}

HollowSwing::Cell HollowSwing::cellAt(double angle_rad) const noexcept {
  const double within = within_rad(angle_rad);
  const auto above = std::upper_bound(angles_rad_.begin() + 1, angles_rad_.end() - 1, within);
  const auto low = static_cast<std::size_t>(above - angles_rad_.begin()) - 1;
  return {low, (within - angles_rad_[low]) / (angles_rad_[low + 1] - angles_rad_[low])};
}

RodPose HollowSwing::poseAt(double angle_rad) const noexcept {
  const Cell cell = cellAt(angle_rad);
  return poseBetween(poses_[cell.low], poses_[cell.low + 1], cell.share);
}

HollowSwing::Load HollowSwing::at(double angle_rad) const noexcept {
  const Cell cell = cellAt(angle_rad);
  const Load& low = loads_[cell.low];
  const Load& high = loads_[cell.low + 1];
  const auto mix = [&cell](double from, double to) { return from + cell.share * (to - from); };
  Load load{mix(low.torque_Nm, high.torque_Nm), {}, {}};
  for (std::size_t k = 0; k < load.twist_rad.size(); ++k) {
    load.twist_rad[k] = mix(low.twist_rad[k], high.twist_rad[k]);
    load.twistRate[k] = mix(low.twistRate[k], high.twistRate[k]);
  }
  return load;
}

}  // namespace torsio
