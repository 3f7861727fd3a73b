// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices/device_monitor.h"

#include <memory>

#include "app/services/devices/held_up.h"
#include "sim/core/angle.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Describes the device's state in words.
std::string deviceStateText(const DeviceSnapshot& snapshot) {
  switch (snapshot.state) {
    case DeviceState::kOpened:
      return "starting";
    case DeviceState::kNeedsCalibration:
      if (snapshot.calibration == CalibrationState::kFailed) {
        return "calibration failed";
      }
      if (snapshot.calibration == CalibrationState::kUpdating) {
        return "being calibrated";
      }
      return "put the stylus into the inkwell";
    case DeviceState::kReady:
      return "ready, force off";
    case DeviceState::kRunning:
      return "ready, force on";
    case DeviceState::kDegraded:
      return (snapshot.sample.status & kDeviceWarm) != 0 ? "motors warm, force off"
                                                         : "servo too slow, force off";
    case DeviceState::kSilent:
      return "the servo does not call";
    case DeviceState::kLost:
      return "connection lost";
    case DeviceState::kClosed:
      return "closed";
  }
  return "";
}

/// Describes an event in a word or two.
std::string eventText(const DeviceEvent& event) {
  switch (event.kind) {
    case DeviceEvent::Kind::kButtons:
      return event.value == 0 ? "buttons released" : "buttons pressed: " + std::to_string(event.value);
    case DeviceEvent::Kind::kError:
      return "error " + std::to_string(event.code);
    case DeviceEvent::Kind::kCalibration:
      return "calibration changed";
    case DeviceEvent::Kind::kRollStop:
      return "stylus at its stop";
    case DeviceEvent::Kind::kJump:
      return "position leapt";
    case DeviceEvent::Kind::kGap:
      return "servo paused";
    case DeviceEvent::Kind::kLost:
      return "lost";
    case DeviceEvent::Kind::kFrozen:
      return "position stands still";
  }
  return "";
}

DeviceReadout readout(const DeviceSnapshot& now, double time_s) {
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

void requireServo(const DeviceSnapshot& now, const std::string& model, const HeldUp& heldUp) {
  if (now.state != DeviceState::kSilent) {
    return;
  }
  if (heldUp.starved()) {
    throw Error(ErrorCode::kDevice, heldUp.sentence(), model, HeldUp::remedy());
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
  const std::unique_ptr<HapticDevice> opened =
      chosenDriver(request.choice).open(deviceRequest(request.choice, request.cancelled));
  HapticDevice& device = *opened;
  device.serve();
  const MonotonicClock clock;
  const std::int64_t begun_us = clock.now_us();
  HeldUp heldUp;
  DeviceSnapshot now;
  for (double time_s = 0.0; time_s < request.seconds;
       time_s = 1e-6 * static_cast<double>(clock.now_us() - begun_us)) {
    heldUp.pause_s(request.interval_s);
    if (request.cancelled && request.cancelled()) {
      return;
    }
    now = device.snapshot();
    DeviceReadout shown = readout(now, 1e-6 * static_cast<double>(clock.now_us() - begun_us));
    for (DeviceEvent event; device.nextEvent(event);) {
      shown.events.push_back(eventText(event));
    }
    request.show(shown);
    if (now.state == DeviceState::kLost && heldUp.starved()) {
      throw Error(ErrorCode::kDevice, Text::tr("%1; %2", heldUp.sentence(), device.lossText(now.lostBecause)),
                  device.capabilities().model, HeldUp::remedy());
    }
    if (now.state == DeviceState::kLost) {
      throw Error(ErrorCode::kDevice, device.lossText(now.lostBecause), device.capabilities().model,
                  Text::tr("Check cable and power, plug the device in again and start again"));
    }
    requireServo(now, device.capabilities().model, heldUp);
  }
  if (now.timing.ticks == 0) {
    now.state = DeviceState::kSilent;  // not watched long enough to know
  }
  requireServo(now, device.capabilities().model, heldUp);
}

}  // namespace torsio
