// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/device/device_state.h"
#include "sim/device/hdapi/hdapi_abi.h"

namespace torsio {

/// Time between two questions for the state of calibration; the device calibrates itself whenever the
/// stylus sits in the inkwell.
inline constexpr std::int64_t kCalibrationCheck_us = 1'000'000;
/// Number of refused updates in a row after which the flow waits for the user.
inline constexpr int kCalibrationTries = 5;

/// The steps from an unknown to a calibrated device, without any call of the library: the servo frame asks,
/// the flow decides. Servo thread; a plain value.
class CalibrationFlow {
 public:
  /// Tells whether the device should be asked now.
  [[nodiscard]] bool due(std::int64_t now_us) const noexcept {
    return state_ != CalibrationState::kFailed && (!asked_ || now_us - asked_us_ >= kCalibrationCheck_us);
  }
  /// Takes the device's answer; true when hdUpdateCalibration must be called once.
  [[nodiscard]] bool answered(hd::Enum result, std::int64_t now_us) noexcept {
    asked_ = true;
    asked_us_ = now_us;
    if (result == hd::kCalibrationOk) {
      tries_ = 0;
      state_ = CalibrationState::kCalibrated;
    } else if (result == hd::kCalibrationNeedsUpdate) {
      state_ = CalibrationState::kUpdating;
      return true;
    } else {
      state_ = CalibrationState::kDockStylus;
    }
    return false;
  }
  /// Takes the result of the update. Whether the device is calibrated is asked anew after the usual pause.
  void updated(bool refused) noexcept {
    tries_ = refused ? tries_ + 1 : 0;
    if (tries_ >= kCalibrationTries) {
      state_ = CalibrationState::kFailed;
    }
  }
  /// Begins anew because the user asks for another attempt.
  void retry() noexcept { *this = {}; }

  [[nodiscard]] CalibrationState state() const noexcept { return state_; }
  [[nodiscard]] bool calibrated() const noexcept { return state_ == CalibrationState::kCalibrated; }

 private:
  CalibrationState state_ = CalibrationState::kUnknown;
  bool asked_ = false;
  std::int64_t asked_us_ = 0;
  int tries_ = 0;
};

}  // namespace torsio
