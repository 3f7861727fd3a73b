// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/trace_data.h"

#include <algorithm>
#include <utility>

#include "assessment/attempt/recorded_loads.h"
#include "sim/core/angle.h"
#include "sim/tissue/hollow/perfusion.h"
#include "sim/tissue/hollow/wrung_organ.h"

namespace torsio::gui {

namespace {

constexpr std::size_t kMaxStretches = 65'536;  // a dozen per pixel of the widest screen
constexpr float kPercent = 100.0F;

std::array<float, kTraces> valuesOf(const Sample& sample) {
  const HollowReading& organ = sample.hollow;
  return {static_cast<float>(degrees(sample.response.angle_rad)),
          static_cast<float>(sample.response.torque_Nm),
          static_cast<float>(tissueForce_N(sample)),
          kPercent * static_cast<float>(organ.flow),
          static_cast<float>(organ.dose),
          kPercent * static_cast<float>(blackShare(organ.dose)),
          kPercent * static_cast<float>(organ.patency),
          static_cast<float>(organ.pressure_Pa / kPascalsPerMmHg)};
}

}  // namespace

TraceCollector::TraceCollector(std::int64_t samples)
    : perStretch_((static_cast<std::size_t>(std::max<std::int64_t>(samples, 0)) + kMaxStretches - 1) /
                  kMaxStretches) {
  perStretch_ = std::max<std::size_t>(perStretch_, 1);
}

void TraceCollector::add(std::span<const Sample> samples) {
  for (const Sample& sample : samples) {
    if (!begun_) {
      begin_us_ = sample.device.time_us;
      traces_ = areOfDetorsion(sample.rules) ? kTraces : kTracesOfATwist;
    }
    begun_ = true;
    const std::array<float, kTraces> now = valuesOf(sample);
    data_.duration_us = sample.device.time_us - begin_us_;
    if (inStretch_ == 0) {
      data_.times_us.push_back(data_.duration_us);
    }
    for (std::size_t lane = 0; lane < traces_; ++lane) {
      std::vector<float>& values = values_[lane];
      if (inStretch_ == 0) {
        values.insert(values.end(), 2, now[lane]);
      } else {
        values[values.size() - 2] = std::min(values[values.size() - 2], now[lane]);
        values.back() = std::max(values.back(), now[lane]);
      }
    }
    inStretch_ = (inStretch_ + 1) % perStretch_;
  }
}

TraceData TraceCollector::finish() {
  for (std::size_t lane = 0; lane < traces_; ++lane) {
    data_.values.emplace_back(std::move(values_[lane]));
  }
  if (traces_ == kTraces) {
    const RangePyramid::Range open = data_.values[static_cast<std::size_t>(TraceKind::kPatency)].whole();
    const RangePyramid::Range full = data_.values[static_cast<std::size_t>(TraceKind::kPressure)].whole();
    if (open.low >= kPercent && full.low == 0.0F && full.high == 0.0F) {
      data_.values.resize(kTracesOfVessels);
    }
  }
  return std::move(data_);
}

}  // namespace torsio::gui
