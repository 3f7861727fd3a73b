// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "sim/core/latest_value.h"
#include "sim/core/spsc_ring.h"
#include "sim/device/device_driver.h"
#include "sim/device/haptic_device.h"
#include "sim/device/steering/rate_steering.h"

namespace torsio {

/// What a device that is pushed and turned says: the part that differs from one to the next.
class SteeringSource {
 public:
  virtual ~SteeringSource() = default;
  /// Asks for the newest deflections without waiting; empty when the connection broke off. One thread, not
  /// the one that made it.
  [[nodiscard]] virtual std::optional<SteeringInput> poll() = 0;
};

/// Age of a reading after which it is marked stale, and after which the device counts as lost.
inline constexpr std::int64_t kSteeringStale_us = 100'000;
inline constexpr std::int64_t kSteeringLost_us = 2'000'000;

/// A device without force whose deflections are speeds: game controller, six-axis puck. A thread of its own
/// asks the source a thousand times a second, steers (RateSteering) and publishes; the servo reads the
/// newest.
/// Position and orientation are the summed deflections, in a cube about the organ; the grip is a trigger or
/// a button, smoothed. Forces are not rendered: the views show them.
class SteeredDevice final : public HapticDevice {
 public:
  /// `identity.model` names it to people.
  SteeredDevice(std::unique_ptr<SteeringSource> source, DeviceIdentity identity,
                const DeviceRequest& request);
  ~SteeredDevice() override;

  void serve() override;
  bool close() override;
  [[nodiscard]] DeviceSnapshot snapshot() noexcept override;
  [[nodiscard]] bool nextEvent(DeviceEvent& event) noexcept override { return events_.pop(event); }
  [[nodiscard]] const DeviceIdentity& identity() const noexcept override { return identity_; }
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override;
  void write(const ForceCommand&) noexcept override {}

 private:
  struct Published {
    DeviceSample sample;
    std::uint64_t number = 0;  // 0: nothing yet
  };
  void follow();

  std::unique_ptr<SteeringSource> source_;  // of the thread, once there is one
  const DeviceIdentity identity_;
  DeviceCapabilities capabilities_;
  RateSteering steering_;
  std::thread thread_;
  std::atomic<bool> ending_{false};
  LatestValue<Published> readings_;
  LatestValue<DeviceSnapshot> snapshots_;
  SpscRing<DeviceEvent> events_;
  bool closed_ = false;
  // Servo thread.
  std::uint64_t lastNumber_ = 0;
  std::int64_t lastNew_us_ = 0;
  bool read_ = false;
};

}  // namespace torsio
