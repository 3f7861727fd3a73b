// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/tool/tool_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/core/error.h"
#include "sim/core/short_number.h"

namespace torsio {

namespace {

constexpr double kFeltJaw_mm = 20.0;  // jaws of the force

/// Mean and longest direction of the points for which `wanted` holds true.
template <typename Wanted>
std::pair<Vec3, Vec3> lineThrough(const ToolPoints& points, const Vec3& start, const Wanted& wanted) {
  Vec3 sum;
  double weight = 0.0;
  for (std::size_t n = 0; n < points.shares.size(); ++n) {
    if (wanted(points.places_mm[n])) {
      sum += points.shares[n] * points.places_mm[n];
      weight += points.shares[n];
    }
  }
  const Vec3 middle = weight > 0.0 ? sum / weight : start;
  std::array<Vec3, 3> spread{};
  for (std::size_t n = 0; n < points.shares.size(); ++n) {
    if (wanted(points.places_mm[n])) {
      const Vec3 from = points.places_mm[n] - middle;
      spread[0] += points.shares[n] * from.x * from;
      spread[1] += points.shares[n] * from.y * from;
      spread[2] += points.shares[n] * from.z * from;
    }
  }
  constexpr int kRounds = 200;  // of the power method; a tool is much longer than wide
  Vec3 direction = normalized(start + Vec3{1e-3, 2e-3, 3e-3});
  for (int round = 0; round < kRounds; ++round) {
    const Vec3 next{dot(spread[0], direction), dot(spread[1], direction), dot(spread[2], direction)};
    if (norm(next) == 0.0) {
      break;
    }
    direction = normalized(next);
  }
  return {middle, direction};
}

/// Which way the tip lies.
Vec3 fromTipToHand(const ToolPoints& points, const ToolPlaces& places, const Vec3& middle,
                   const Vec3& direction) {
  if (places.shaft) {
    return dot(direction, *places.shaft) < 0.0 ? -1.0 * direction : direction;
  }
  if (places.tip_mm) {
    return dot(direction, middle - *places.tip_mm) < 0.0 ? -1.0 * direction : direction;
  }
  const auto [least, most] = reachAlong(points, middle, direction);
  const double low = shareBetween(points, middle, direction, least, least + places.pivot_mm);
  const double high = shareBetween(points, middle, direction, most - places.pivot_mm, most);
  return high < low ? -1.0 * direction : direction;
}

void turnAcross(ToolFrame& frame, const Vec3& towards) {
  const Vec3 across = towards - dot(towards, frame.z) * frame.z;
  frame.x = normalized(across);
  frame.y = cross(frame.z, frame.x);
}

bool isNear(const ToolLine& line, const Vec3& place_mm) {
  const Vec3 from = place_mm - line.point_mm;
  return norm(from - dot(from, line.direction) * line.direction) <= line.within_mm;
}

}  // namespace

std::pair<double, double> reachAlong(const ToolPoints& points, const Vec3& from, const Vec3& direction) {
  double least = 1e9;
  double most = -1e9;
  for (std::size_t n = 0; n < points.shares.size(); ++n) {
    if (points.shares[n] >= points.solid) {
      const double at = dot(points.places_mm[n] - from, direction);
      least = std::min(least, at);
      most = std::max(most, at);
    }
  }
  return {least, most};
}

double shareBetween(const ToolPoints& points, const Vec3& from, const Vec3& direction, double low_mm,
                    double high_mm) {
  double sum = 0.0;
  for (std::size_t n = 0; n < points.shares.size(); ++n) {
    const double at = dot(points.places_mm[n] - from, direction);
    sum += at >= low_mm && at < high_mm ? points.shares[n] : 0.0;
  }
  return sum;
}

Vec3 broadestAcross(const ToolPoints& points, const ToolFrame& frame, double pivot_mm) {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (std::size_t n = 0; n < points.shares.size(); ++n) {
    const Vec3 at = frame.local_mm(points.places_mm[n]);
    if (at.z < 0.8 * pivot_mm) {
      xx += points.shares[n] * at.x * at.x;
      yy += points.shares[n] * at.y * at.y;
      xy += points.shares[n] * at.x * at.y;
    }
  }
  // The longer axis of the ellipse of inertia.
  const double apart = std::hypot(xx - yy, 2.0 * xy);
  const Vec3 along = (xx - yy + apart) * frame.x + 2.0 * xy * frame.y;
  return norm(along) > 0.0 ? along : frame.y;
}

ToolFrame toolFrame(const ToolPoints& points, const ToolPlaces& places,
                    const std::optional<ToolLine>& shaft) {
  const auto all = [](const Vec3&) { return true; };
  const std::pair<Vec3, Vec3> whole = shaft ? std::pair(shaft->point_mm, shaft->direction)
                                            : lineThrough(points, places.shaft.value_or(Vec3{0, 0, 1}), all);
  Vec3 middle = whole.first;
  ToolFrame frame;
  frame.z = fromTipToHand(points, places, middle, whole.second);
  for (int round = 0; round < 3; ++round) {  // the line of the shaft alone, without the jaws
    const double least = reachAlong(points, middle, frame.z).first;
    const auto [shaftMiddle, along] = lineThrough(points, frame.z, [&](const Vec3& place_mm) {
      return dot(place_mm - middle, frame.z) > least + places.pivot_mm + kBehindHinge_mm &&
             (!shaft || isNear(*shaft, place_mm));
    });
    frame.z = places.shaft ? normalized(*places.shaft) : dot(along, frame.z) < 0.0 ? -1.0 * along : along;
    middle = shaftMiddle;
  }
  const double least = reachAlong(points, middle, frame.z).first;
  frame.tip_mm = middle + (least - points.halfPoint_mm) * frame.z;
  const Vec3 any = std::abs(frame.z.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  turnAcross(frame, any);
  turnAcross(frame, places.jawAxis ? *places.jawAxis : broadestAcross(points, frame, places.pivot_mm));
  return frame;
}

void requireToolPlaces(const ToolPlaces& places, bool others) {
  const auto finite = [](const std::optional<Vec3>& v) { return !v || isFinite(*v); };
  const auto direction = [](const std::optional<Vec3>& v) { return !v || norm(*v) > 0.0; };
  if (!others || !(places.pivot_mm >= 3.0 && places.pivot_mm <= 100.0) || !finite(places.tip_mm) ||
      !finite(places.shaft) || !finite(places.jawAxis) || !direction(places.shaft) ||
      !direction(places.jawAxis)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("a value for the instrument is out of range"), "",
                Text::tr("Give a threshold of -500 to 3000 HU, a hinge 3 to 100 mm behind the tip, and "
                         "directions that are not zero"));
  }
}

void tellPlaces(const ToolPlaces& places, const Vec3& jawAxis, double pivot_mm,
                std::vector<ScanRemark>& remarks) {
  if (!places.jawAxis) {
    const auto share = [](double x) { return shortNumber(std::round(100.0 * x) / 100.0 + 0.0); };
    remarks.push_back({"D22", false,
                       Text::tr("the jaws are assumed to turn about their broad side, %1, %2, %3 in the file",
                                share(jawAxis.x), share(jawAxis.y), share(jawAxis.z)),
                       std::nullopt, Text::tr("Enter the axis of the hinge if it differs")});
  }
  if (std::abs(pivot_mm - kFeltJaw_mm) > 0.5) {
    remarks.push_back({"D22", true,
                       Text::tr("the jaws are %1 mm long; the force is computed with jaws of %2 mm",
                                shortNumber(pivot_mm), shortNumber(kFeltJaw_mm)),
                       pivot_mm, Text::tr("Show this instrument")});
  }
}

}  // namespace torsio
