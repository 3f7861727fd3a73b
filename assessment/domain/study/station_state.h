// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "sim/core/servo_health.h"

namespace torsio {

/// What a station does now.
struct StationState {
  std::string station{};
  TrialId trialId{};  ///< that runs there; empty: none
  UserId userId{};    ///< signed in there; empty: nobody
  std::string softwareVersion{};
  std::int64_t heartbeatUtc_us = 0;  ///< last heartbeat
  std::string deviceJson{};          ///< app/devices/station_device.h; empty: no training station
  bool deviceHaptic = false;
  std::string deviceLight{};             ///< of the last check: "green", "amber", "red"; empty: not checked
  std::string deviceProblemJson{};       ///< empty: none
  std::int64_t deviceCheckedUtc_us = 0;  ///< 0: not checked
  std::string traineeCode{};             ///< filled when read: of the running trial
  SceneId sceneId{};                     ///< filled when read
  std::string phaseLabel{};              ///< filled when read
  std::int64_t startedUtc_us = 0;        ///< filled when read: of the running trial; 0: none
  bool ended = false;                    ///< filled when read: the trial has its closing row already
  std::optional<ServoHealth> lastHealth{};  ///< filled when read: of the last run in real time there
  std::int64_t lastTicks = 0;               ///< filled when read: of that run
  std::int64_t lastEndedUtc_us = 0;         ///< filled when read: 0: none
};

/// Whether trainees train there: it has said which device it has, or a run in real time was recorded there.
/// The desks of raters and administrators are none.
[[nodiscard]] inline bool isTrainingStation(const StationState& station) noexcept {
  return !station.deviceJson.empty() || station.lastEndedUtc_us > 0;
}

/// A station that sent no heartbeat for so long is shown as not answering.
inline constexpr std::int64_t kStationSilence_us = 30'000'000;

}  // namespace torsio
