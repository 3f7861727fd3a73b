// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices/station_device.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/services/base/stored_sentence.h"

namespace torsio {

namespace {

constexpr std::array<std::pair<Light, const char*>, 3> kLights{
    {{Light::kGreen, "green"}, {Light::kAmber, "amber"}, {Light::kRed, "red"}}};

}  // namespace

StationDevice stationDevice(const DeviceReadiness& readiness, std::int64_t checkedUtc_us) {
  StationDevice device{.device = readiness.device,
                       .haptic = readiness.haptic,
                       .light = readiness.light(),
                       .checkedUtc_us = checkedUtc_us};
  if (*device.light == Light::kGreen) {
    return device;
  }
  const auto worst =
      std::find_if(readiness.findings.begin(), readiness.findings.end(),
                   [&](const ReadinessFinding& finding) { return finding.light == device.light; });
  if (worst != readiness.findings.end()) {
    device.problem = worst->detail;
  }
  if (!readiness.haptic && *device.light == Light::kAmber) {
    device.problem = Text::tr("the force is not felt");
  }
  return device;
}

StationDevice uncheckedDevice(const Text& device, bool haptic) {
  return {.device = device.empty() ? Text::tr("Mouse and keyboard") : device, .haptic = haptic};
}

void storeDevice(const StationDevice& device, StationState& state) {
  state.deviceJson = storedSentence(device.device);
  state.deviceHaptic = device.haptic;
  state.deviceProblemJson = storedSentence(device.problem);
  state.deviceCheckedUtc_us = device.checkedUtc_us;
  state.deviceLight.clear();
  for (const auto& [light, code] : kLights) {
    if (device.light == light) {
      state.deviceLight = code;
    }
  }
}

StationDevice storedDevice(const StationState& state) {
  StationDevice device{.device = readSentence(state.deviceJson),
                       .haptic = state.deviceHaptic,
                       .problem = readSentence(state.deviceProblemJson),
                       .checkedUtc_us = state.deviceCheckedUtc_us};
  for (const auto& [light, code] : kLights) {
    if (state.deviceLight == code) {
      device.light = light;
    }
  }
  return device;
}

}  // namespace torsio
