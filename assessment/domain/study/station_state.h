// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "sim/core/servo_health.h"

namespace torsio {

struct StationState {
  std::string station{};
  TrialId trialId{};  ///< running there; empty: none
  UserId userId{};    ///< signed in there; empty: nobody
  std::string softwareVersion{};
  std::int64_t heartbeatUtc_us = 0;  ///< last heartbeat
  std::string deviceJson{};          ///< app/services/devices/device_readiness.h; empty: no training station
  bool deviceHaptic = false;
  std::string deviceLight{};        ///< result of the last check: "green", "amber", "red"; empty: not checked
  std::string deviceProblemJson{};  ///< empty: none
  std::int64_t deviceCheckedUtc_us = 0;     ///< 0: not checked
  std::string traineeCode{};                ///< filled when read: of the running trial
  SceneId sceneId{};                        ///< filled when read
  std::string phaseLabel{};                 ///< filled when read
  std::int64_t startedUtc_us = 0;           ///< filled when read: of the running trial; 0: none
  bool ended = false;                       ///< filled when read: the trial already has its closing row
  std::optional<ServoHealth> lastHealth{};  ///< filled when read: of the last run in real time there
  std::int64_t lastTicks = 0;               ///< filled when read: of that run
  std::int64_t lastEndedUtc_us = 0;         ///< filled when read: 0: none
};

/// True if trainees train there: the station has reported a device, or a real-time run was recorded there.
/// False for desks of raters and administrators.
[[nodiscard]] inline bool isTrainingStation(const StationState& station) noexcept {
  return !station.deviceJson.empty() || station.lastEndedUtc_us > 0;
}

/// A station without a heartbeat for this long is shown as not responding.
inline constexpr std::int64_t kStationSilence_us = 30'000'000;

}  // namespace torsio
