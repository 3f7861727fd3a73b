// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/station_device.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace torsio {

namespace {

constexpr std::array<std::pair<Light, const char*>, 3> kLights{
    {{Light::kGreen, "green"}, {Light::kAmber, "amber"}, {Light::kRed, "red"}}};

/// A sentence as [pattern, argument ...], the arguments sentences themselves.
nlohmann::json jsonOf(const Text& text) {
  nlohmann::json json = nlohmann::json::array({text.pattern()});
  for (const Text& argument : text.arguments()) {
    json.push_back(jsonOf(argument));
  }
  return json;
}

Text textOf(const nlohmann::json& json) {
  if (!json.is_array() || json.empty() || !json[0].is_string()) {
    return {};
  }
  const auto pattern = json[0].get<std::string>();
  std::vector<Text> given;
  for (std::size_t i = 1; i < json.size(); ++i) {
    given.push_back(textOf(json[i]));
  }
  return Text::restored(pattern, std::move(given));
}

std::string stored(const Text& text) {
  return text.empty() ? std::string() : jsonOf(text).dump();
}

Text read(const std::string& json) {
  return json.empty() ? Text() : textOf(nlohmann::json::parse(json, nullptr, false));
}

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
  state.deviceJson = stored(device.device);
  state.deviceHaptic = device.haptic;
  state.deviceProblemJson = stored(device.problem);
  state.deviceCheckedUtc_us = device.checkedUtc_us;
  state.deviceLight.clear();
  for (const auto& [light, code] : kLights) {
    if (device.light == light) {
      state.deviceLight = code;
    }
  }
}

StationDevice storedDevice(const StationState& state) {
  StationDevice device{.device = read(state.deviceJson),
                       .haptic = state.deviceHaptic,
                       .problem = read(state.deviceProblemJson),
                       .checkedUtc_us = state.deviceCheckedUtc_us};
  for (const auto& [light, code] : kLights) {
    if (state.deviceLight == code) {
      device.light = light;
    }
  }
  return device;
}

}  // namespace torsio
