// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_model_operation.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/contracts.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

constexpr int kNodes = 257;           // of an elastic table over a part of the organ
constexpr int kStiffnessNodes = 65;   // grasps for which the torque of a given profile is worked out
constexpr double kEndMargin = 0.005;  // a peak stays this share of the twisted part off its start
constexpr double kLeastCell = 1e-12;  // share of the organ's compliance between two nodes
constexpr double kLeastReach = 1e-3;  // share of the organ's compliance that an axis must meet

}  // namespace

PreparedOperation::PreparedOperation(const TwistOperation& operation, int index, const OperationBase& base)
    : definition_(operation) {
  const double length = base.axis->length_m();
  unit_m_ = length;
  if (operation.axis == TwistAxis::kStraight) {
    const Vec3 way = operation.axisTo_m - operation.axisFrom_m;
    direction_ = normalized(way);
    alongAxis_ = operation.coordinate == TwistCoordinate::kAlongAxis;
    if (alongAxis_) {
      unit_m_ = norm(way);
    }
  }
  std::vector<double> peaks;
  const double low = unit_m_ * (operation.from + kEndMargin * (operation.to - operation.from));
  const double high = unit_m_ * operation.to;
  for (int i = 0; i < base.compliance->nodes(); ++i) {
    const double arc = base.compliance->first() + base.compliance->step() * i;
    const double own = operation.peak ? *operation.peak * unit_m_ : coordinateAt(*base.axis, arc);
    peaks.push_back(std::clamp(own, low, high));
  }
  peak_ = HermiteTable(base.compliance->first(), base.compliance->step(), std::move(peaks), true);
  if (isElastic()) {
    prepareElastic(index, base);
  }
  prepareStiffness(base);
}

// Turn about the operation's axis for 1 N m about it, of the organ between two nodes (Castigliano): the
// component of the torque along the centreline twists, the component across bends.
double PreparedOperation::cellCompliance(const OperationBase& base, int cell) const {
  const HermiteTable& whole = *base.series;
  const double least = kLeastCell * whole.node(whole.nodes() - 1);
  const double twist = std::max(whole.node(cell + 1) - whole.node(cell), least);
  if (aboutCentreline()) {
    return twist;
  }
  const double along =
      dot(direction_, base.axis->frameAt(whole.first() + (cell + 0.5) * whole.step()).tangent);
  const double bend = base.bending->node(cell + 1) - base.bending->node(cell);
  return along * along * twist + (1.0 - along * along) * bend;
}

double PreparedOperation::coordinateAt(const Centreline& axis, double arc_m) const {
  return alongAxis_ ? way(axis.frameAt(arc_m).centre_m) : arc_m;
}

void PreparedOperation::prepareElastic(int index, const OperationBase& base) {
  const HermiteTable& whole = *base.compliance;
  const double from = unit_m_ * definition_.from;
  const double step = unit_m_ * (definition_.to - definition_.from) / (kNodes - 1);
  std::vector<double> nodes(kNodes, 0.0);
  const bool wholeOrgan = definition_.from == 0.0 && definition_.to == 1.0;
  if (aboutCentreline() && wholeOrgan) {
    nodes.clear();
    for (int i = 0; i < whole.nodes(); ++i) {
      nodes.push_back(whole.node(i));
    }
    elastic_ = TorsionTable(whole.first(), whole.step(), std::move(nodes), base.ends, {base.foundation_m},
                            base.paperAngles);
    return;
  }
  // Each piece of the organ adds its compliance where it lies along the coordinate.
  for (int cell = 0; cell + 1 < whole.nodes(); ++cell) {
    const double arc = whole.first() + whole.step() * cell;
    const double weight = cellCompliance(base, cell);
    const double a = coordinateAt(*base.axis, arc);
    const double b = coordinateAt(*base.axis, arc + whole.step());
    const double low = std::min(a, b);
    const double width = std::abs(b - a);
    for (int i = 0; i < kNodes; ++i) {
      const double x = from + step * i;
      const double part = width > 0.0 ? std::clamp((x - low) / width, 0.0, 1.0) : (x >= low ? 1.0 : 0.0);
      nodes[static_cast<std::size_t>(i)] += weight * part;
    }
  }
  if (!(nodes.back() - nodes.front() > kLeastReach * base.series->node(whole.nodes() - 1))) {
    throw Error(ErrorCode::kBadParameter,
                Text::verbatim("the organ hardly reaches along the axis of an elastic twist"),
                Text::verbatim("twist operation %1", std::to_string(index + 1)),
                Text::verbatim("Use a ramp or a tent, or another axis or range."));
  }
  elastic_ = TorsionTable(from, step, std::move(nodes), base.ends, {base.foundation_m});
}

double PreparedOperation::profileStiffness(const OperationBase& base, double peak) const {
  const HermiteTable& whole = *base.compliance;
  double given = 0.0;
  double free = 0.0;
  double before = share(coordinateAt(*base.axis, whole.first()), peak).value;
  for (int cell = 0; cell + 1 < whole.nodes(); ++cell) {
    const double arc = whole.first() + whole.step() * (cell + 1);
    const double after = share(coordinateAt(*base.axis, arc), peak).value;
    const double compliance = cellCompliance(base, cell);
    given += (after - before) * (after - before) / compliance;
    free += compliance;
    before = after;
  }
  return std::max(given, 1.0 / free);
}

void PreparedOperation::prepareStiffness(const OperationBase& base) {
  if (isElastic()) {
    return;  // the table of the elastic twist knows it exactly
  }
  const double length = base.axis->length_m();
  std::vector<double> values;
  values.reserve(kStiffnessNodes);
  for (int i = 0; i < kStiffnessNodes; ++i) {
    values.push_back(profileStiffness(base, peakFor(length * i / (kStiffnessNodes - 1))));
  }
  stiffness_ = HermiteTable(0.0, length / (kStiffnessNodes - 1), std::move(values), true);
}

double PreparedOperation::peakFor(double graspArc_m) const noexcept {
  if (!alongAxis_ && !definition_.peak) {
    const double low = definition_.from + kEndMargin * (definition_.to - definition_.from);
    return std::clamp(graspArc_m, unit_m_ * low, unit_m_ * definition_.to);
  }
  return peak_.value(graspArc_m);
}

ValueSlope PreparedOperation::share(double coordinate, double peak) const noexcept {
  if (isElastic()) {
    return elastic_.share(coordinate, peak);
  }
  const double x = coordinate / unit_m_;
  const double at = peak / unit_m_;
  return {profileShare(definition_, x, at), profileSlope(definition_, x, at) / unit_m_};
}

ValueSlope PreparedOperation::blendedShare(double coordinate, double peak, double width) const noexcept {
  return isElastic() ? elastic_.blendedShare(coordinate, peak, width) : share(coordinate, peak);
}

double PreparedOperation::stiffness(double graspArc_m) const noexcept {
  if (isElastic()) {
    return 1.0 / elastic_.compliance(peakFor(graspArc_m));
  }
  return stiffness_.value(graspArc_m);
}

}  // namespace torsio
