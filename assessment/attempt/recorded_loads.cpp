// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/recorded_loads.h"

#include <algorithm>
#include <cmath>

#include "sim/core/device_sample.h"

namespace torsio {

namespace {

constexpr std::uint32_t kNobodyLeads = kDeviceLost | kDeviceUncalibrated | kDeviceEnded;

bool handLeads(const Sample& sample) noexcept {
  return (sample.device.status & kNobodyLeads) == 0;
}

}  // namespace

double tissueForce_N(const Sample& sample) noexcept {
  return handLeads(sample) ? norm(sample.response.force_N) : 0.0;
}

bool tissueForceKnown(const Sample& sample) noexcept {
  // An invalid reading also inhibits the device, but the tissue was computed for the last valid one.
  const bool badReading = (sample.device.status & kDeviceInvalid) != 0;
  const std::uint32_t doubts = kForceModelLate | (badReading ? kForceFull : kForceNotFinite);
  return !handLeads(sample) || (sample.limits & doubts) == 0;
}

RecordedLoads recordedLoads(std::span<const Sample> samples) noexcept {
  bool touched = false;
  bool known = true;
  double tissue_N = 0.0;
  double device_N = 0.0;
  double torque_Nm = 0.0;
  for (const Sample& sample : samples) {
    touched = touched || sample.contact != kContactNone || sample.phase != ExercisePhase::kTracking;
    known = known && tissueForceKnown(sample);
    tissue_N = std::max(tissue_N, tissueForce_N(sample));
    device_N = std::max(device_N, norm(sample.force_N));
    torque_Nm = std::max(torque_Nm, std::abs(sample.response.torque_Nm));
  }
  RecordedLoads loads;
  if (!touched) {
    return loads;
  }
  loads.deviceForce_N = device_N;
  if (known) {
    loads.tissueForce_N = tissue_N;
    loads.torque_Nm = torque_Nm;
  }
  return loads;
}

}  // namespace torsio
