// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_operation.h"

#include <algorithm>
#include <string>

#include "sim/base/error.h"

namespace torsio {

namespace {

constexpr double kShortestAxis_m = 1e-3;

bool isTent(TwistProfile profile) {
  return profile == TwistProfile::kTent || profile == TwistProfile::kSmoothTent;
}

bool isSmooth(TwistProfile profile) {
  return profile == TwistProfile::kSmoothRamp || profile == TwistProfile::kSmoothTent;
}

[[noreturn]] void refuse(std::size_t index, const Text& what, const Text& remedy) {
  throw Error(ErrorCode::kBadParameter, what, Text::verbatim("twist operation %1", std::to_string(index + 1)),
              remedy);
}

void checkStraightAxis(std::size_t index, const TwistOperation& op) {
  if (!isFinite(op.axisFrom_m) || !isFinite(op.axisTo_m)) {
    refuse(index, Text::verbatim("an axis point is not a number"),
           Text::verbatim("Give two finite points in metres."));
  }
  if (norm(op.axisTo_m - op.axisFrom_m) < kShortestAxis_m) {
    refuse(index, Text::verbatim("the axis points are closer together than 1 mm"),
           Text::verbatim("Give two landmarks that lie apart."));
  }
}

void checkRange(std::size_t index, const TwistOperation& op) {
  if (!std::isfinite(op.from) || !std::isfinite(op.to) || !(op.to > op.from)) {
    refuse(index,
           Text::verbatim("the twisted part runs from %1 to %2, but its end must lie beyond its start",
                          std::to_string(op.from), std::to_string(op.to)),
           Text::verbatim("Give from < to."));
  }
  const bool alongAxis = op.axis == TwistAxis::kStraight && op.coordinate == TwistCoordinate::kAlongAxis;
  if (!alongAxis && (op.from < 0.0 || op.to > 1.0)) {
    refuse(index, Text::verbatim("a fraction of the organ's length lies outside 0..1"),
           Text::verbatim("Give 0 <= from < to <= 1."));
  }
  if (op.peak && !(*op.peak > op.from && *op.peak <= op.to)) {
    refuse(index, Text::verbatim("the peak at %1 lies outside the twisted part", std::to_string(*op.peak)),
           Text::verbatim("Give from < peak <= to."));
  }
}

}  // namespace

double profileShare(const TwistOperation& operation, double x, double peak) noexcept {
  double t = 1.0;
  if (x < peak) {
    t = std::clamp((x - operation.from) / (peak - operation.from), 0.0, 1.0);
  } else if (isTent(operation.profile) && x > peak) {
    t = operation.to > peak ? std::clamp((operation.to - x) / (operation.to - peak), 0.0, 1.0) : 0.0;
  }
  return isSmooth(operation.profile) ? t * t * (3.0 - 2.0 * t) : t;
}

double profileSlope(const TwistOperation& operation, double x, double peak) noexcept {
  double t = 1.0;
  double rate = 0.0;
  if (x < peak) {
    rate = 1.0 / (peak - operation.from);
    t = (x - operation.from) * rate;
  } else if (isTent(operation.profile) && operation.to > peak) {
    rate = -1.0 / (operation.to - peak);
    t = (x - operation.to) * rate;
  }
  if (!(t > 0.0 && t <= 1.0)) {
    return 0.0;
  }
  return isSmooth(operation.profile) ? 6.0 * t * (1.0 - t) * rate : rate;
}

void checkOperations(std::span<const TwistOperation> operations) {
  if (operations.size() > static_cast<std::size_t>(kMostOperations)) {
    throw Error(ErrorCode::kBadParameter,
                Text::verbatim("%1 twist operations in one pattern", std::to_string(operations.size())),
                Text::verbatim("twist pattern"),
                Text::verbatim("Give at most %1.", std::to_string(kMostOperations)));
  }
  for (std::size_t i = 0; i < operations.size(); ++i) {
    const TwistOperation& op = operations[i];
    if (op.axis == TwistAxis::kStraight) {
      checkStraightAxis(i, op);
    }
    checkRange(i, op);
    if (!std::isfinite(op.ratio) || op.ratio == 0.0) {
      refuse(i, Text::verbatim("the ratio %1 turns nothing", std::to_string(op.ratio)),
             Text::verbatim("Give a finite ratio other than 0."));
    }
  }
}

}  // namespace torsio
