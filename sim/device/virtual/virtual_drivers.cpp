// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/virtual/virtual_drivers.h"

#include <utility>

#include "sim/device/virtual/pointer_device.h"
#include "sim/device/virtual/scripted_hand.h"

namespace torsio {

ReplayDevice::ReplayDevice(std::vector<DeviceSample> samples, DeviceCapabilities capabilities)
    : samples_(std::move(samples)), capabilities_(std::move(capabilities)) {
  capabilities_.realTime = false;
}

DeviceSample ReplayDevice::read(std::int64_t time_us) noexcept {
  if (next_ < samples_.size()) {
    return samples_[next_++];
  }
  DeviceSample last = samples_.empty() ? DeviceSample{} : samples_.back();
  last.time_us = time_us;
  last.status |= kDeviceEnded;
  return last;
}

IdleDevice::IdleDevice(const Pose& pose) {
  capabilities_.model = "Idle";
  capabilities_.realTime = false;
  DeviceReading reading;
  reading.pose = pose;
  sample_ = quantize(reading, sample_);
}

DeviceSample IdleDevice::read(std::int64_t time_us) noexcept {
  sample_.time_us = time_us;
  return sample_;
}

namespace {

/// A driver that needs nothing.
DeviceDriver alwaysThere(const char* id, const char* name, DriverUse use, Text sentence) {
  DeviceDriver driver;
  driver.id = id;
  driver.name = name;
  driver.use = use;
  driver.look = [sentence = std::move(sentence)](const DeviceRequest&) -> DriverFinding {
    return {true, sentence, "", {}};
  };
  return driver;
}

}  // namespace

DeviceDriver pointerDriver() {
  DeviceDriver driver = alwaysThere("pointer", "Mouse and keyboard", DriverUse::kPointer,
                                    Text::tr("always there; shows forces, does not render them"));
  driver.open = [](const DeviceRequest& request) { return std::make_unique<PointerDevice>(request.start); };
  return driver;
}

DeviceDriver scriptedHandDriver() {
  DeviceDriver driver = alwaysThere("scripted", "Scripted hand", DriverUse::kNoHand,
                                    Text::tr("always there; a simulated hand with a seed"));
  driver.open = [](const DeviceRequest& request) {
    ScriptedHandOptions hand;
    hand.task.start_m = request.start.position_m;
    hand.task.graspPoint_m = request.workspaceCentre_m;
    return std::make_unique<ScriptedHand>(hand);
  };
  return driver;
}

DeviceDriver replayDriver() {
  DeviceDriver driver = alwaysThere("replay", "Recorded run", DriverUse::kNoHand,
                                    Text::tr("always there; repeats a recording tick by tick"));
  driver.needs = Text::tr("a recorded run");
  driver.open = [](const DeviceRequest& request) {
    return std::make_unique<ReplayDevice>(request.recorded, request.recordedWith);
  };
  return driver;
}

DeviceDriver idleDriver() {
  DeviceDriver driver = alwaysThere("idle", "Nobody's hand", DriverUse::kNoHand,
                                    Text::tr("always there; the instrument stays where it was put"));
  driver.open = [](const DeviceRequest& request) { return std::make_unique<IdleDevice>(request.start); };
  return driver;
}

}  // namespace torsio
