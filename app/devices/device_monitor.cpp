// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/device_monitor.h"

#include <memory>

#include "sim/base/angle.h"
#include "sim/base/clock.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

/// The state of the device in plain words.
std::string deviceStateText(const HdapiSnapshot& snapshot) {
  switch (snapshot.state) {
    case HdapiState::kOpened:
      return "starting";
    case HdapiState::kNeedsCalibration:
      if (snapshot.calibration == CalibrationState::kFailed) {
        return "calibration failed";
      }
      if (snapshot.calibration == CalibrationState::kUpdating) {
        return "being calibrated";
      }
      return "put the stylus into the inkwell";
    case HdapiState::kReady:
      return "ready, force off";
    case HdapiState::kRunning:
      return "ready, force on";
    case HdapiState::kDegraded:
      return (snapshot.sample.status & kDeviceWarm) != 0 ? "motors warm, force off"
                                                         : "servo too slow, force off";
    case HdapiState::kSilent:
      return "the servo does not call";
    case HdapiState::kLost:
      return "connection lost";
    case HdapiState::kClosed:
      return "closed";
  }
  return "";
}

DeviceReadout readout(const HdapiSnapshot& now, double time_s) {
  const ToolState tool = toolState(now.sample);
  DeviceReadout shown;
  shown.time_s = time_s;
  shown.state = deviceStateText(now);
  shown.tip_mm = tool.pose.position_m * 1e3;
  shown.roll_deg = degrees(tool.roll_rad);
  shown.rollAtStop = now.rollAtStop;
  shown.grip = tool.grip;
  shown.firstButton = (tool.buttons & kButtonGrip) != 0;
  shown.secondButton = (tool.buttons & kButtonSecond) != 0;
  shown.docked = now.docked;
  shown.warmest = now.warmest;
  shown.rate_Hz = now.timing.rate_Hz;
  shown.lateTicks = now.timing.late;
  return shown;
}

void requireServo(const HdapiSnapshot& now, const std::string& model) {
  if (now.state != HdapiState::kSilent) {
    return;
  }
  throw Error(ErrorCode::kDevice,
              now.timing.ticks == 0 ? Text::tr("the library's servo loop never called")
                                    : Text::tr("the library's servo loop stopped calling"),
              model, Text::tr("Close every other program that uses the device; restart the computer"));
}

}  // namespace

void monitorDevice(const DeviceMonitorRequest& request) {
  requireTime(request.seconds, 86'400.0, Text::tr("the time to watch"));
  requireTime(request.interval_s, 60.0, Text::tr("the interval"));
  StylusOpening opening = openStylus(stylusRequest(request.choice, request.cancelled));
  if (opening.driver == nullptr) {
    throw Error(ErrorCode::kDevice, opening.library.sentence, Text::tr("haptic device"),
                opening.library.remedy);
  }
  StylusDriver& device = *opening.driver;
  device.serve();
  const MonotonicClock clock;
  const std::int64_t begun_us = clock.now_us();
  HdapiSnapshot now;
  for (double time_s = 0.0; time_s < request.seconds;
       time_s = 1e-6 * static_cast<double>(clock.now_us() - begun_us)) {
    pause_s(request.interval_s);
    if (request.cancelled && request.cancelled()) {
      return;
    }
    now = device.snapshot();
    request.show(readout(now, 1e-6 * static_cast<double>(clock.now_us() - begun_us)));
    if (now.state == HdapiState::kLost) {
      throw Error(ErrorCode::kDevice, hdapiErrorText(now.lostBecause), device.capabilities().model,
                  Text::tr("Check cable and power, plug the device in again and start anew"));
    }
    requireServo(now, device.capabilities().model);
  }
  if (now.timing.ticks == 0) {
    now.state = HdapiState::kSilent;  // watched for less than the patience
  }
  requireServo(now, device.capabilities().model);
}

}  // namespace torsio
