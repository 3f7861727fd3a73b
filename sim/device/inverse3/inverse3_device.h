// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "sim/core/latest_value.h"
#include "sim/core/pose.h"
#include "sim/core/spsc_ring.h"
#include "sim/device/device_driver.h"
#include "sim/device/hosted_device.h"
#include "sim/device/inverse3/web_socket.h"
#include "sim/device/safety/force_governor.h"

namespace torsio {

/// Longest way of the cursor from the device's origin that is believed, m.
inline constexpr double kInverse3Reach_m = 1.0;

/// One message of the service (version 3, JSON), as far as the driver reads it. Frame of the device: x to the
/// right, y away from the user, z up; metres. What is not in the message stays empty.
struct Inverse3Message {
  std::string deviceId;             ///< of the Inverse3; "": none is connected
  std::string firmware;             ///< config.device_info, in the first message only
  std::optional<Vec3> cursor_m;     ///< state.cursor_position; empty when not finite or out of reach
  std::optional<Quat> orientation;  ///< of the (wireless) VerseGrip; empty without one
  std::uint32_t buttons = 0;        ///< DeviceButton bits: a the jaw, b the second, c the bookmark
};

/// Reads a message. `wanted`: the device of this id; "": the first one. Empty for what is no JSON object.
[[nodiscard]] std::optional<Inverse3Message> inverse3Message(const std::string& json,
                                                             const std::string& wanted);
/// Writes the command that renders a force at the cursor until the next one, N, frame of the device.
[[nodiscard]] std::string inverse3Force(const std::string& deviceId, const Vec3& force_N);

/// Longest wait for a message of the service.
inline constexpr std::int64_t kInverse3Look_us = 5'000;
/// Time after which a force that the servo has not renewed is no longer sent.
inline constexpr std::int64_t kInverse3Stale_us = 20'000;
/// Silence of the service after which the device counts as lost.
inline constexpr std::int64_t kInverse3Lost_us = 250'000;

/// Haply Inverse3 with a VerseGrip, through the WebSocket of its service. A thread of its own answers every
/// state of the service with the newest force; between both it calls the tick, and at least every 5 ms.
/// Readings and forces go over mailboxes. Not confirmed on hardware: limits are the cautious ones of an
/// unknown model.
///
/// | channel     | direction | unit | source                                                      |
/// |-------------|-----------|------|-------------------------------------------------------------|
/// | position    | given     | m    | cursor_position, moved so that kCentre_m lies at the organ  |
/// | orientation | given     | 1    | of the VerseGrip; without one it points away from the user  |
/// | roll        | given     | rad  | the same, about the stylus, unwrapped                       |
/// | grip        | given     | 1    | button a, 0..1 within 0.1 s                                 |
/// | buttons     | given     |      | b second, c bookmark                                        |
/// | status      | given     |      | kDeviceInvalid, kDeviceStale, kDeviceLost, kDeviceUncalibrated |
/// | force       | taken     | N    | set_cursor_force, three axes                                |
///
/// On any doubt - no reading within 5 ms, an invalid one, no force for kInverse3Stale_us, dropForce, force
/// not asked for - the service gets zero, and force returns by a ramp (ForceGate). Every way out sends zero
/// first.
class Inverse3Device final : public HostedDevice {
 public:
  /// `first`: the message in which the service named the device.
  Inverse3Device(std::unique_ptr<WebSocket> service, const Inverse3Message& first,
                 const DeviceRequest& request);
  ~Inverse3Device() override;

  void start(const DeviceTick& tick) override;
  void beginClose() override;
  void switchOff() noexcept override;
  [[nodiscard]] bool silent() const noexcept override { return released(); }
  [[nodiscard]] bool released() const override { return released_.load(std::memory_order_acquire); }
  bool close() override;
  void enableForce(bool on) noexcept override { forceWished_.store(on); }
  void dropForce() noexcept override { drops_.fetch_add(1); }
  [[nodiscard]] DeviceSnapshot snapshot() noexcept override;
  [[nodiscard]] bool nextEvent(DeviceEvent& event) noexcept override { return events_.pop(event); }
  [[nodiscard]] const DeviceIdentity& identity() const noexcept override { return identity_; }
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override;
  void write(const ForceCommand& command) noexcept override;

 private:
  void follow();
  void answer(bool came, const std::string& text, std::int64_t now_us);
  bool take(const std::string& text, std::int64_t now_us);
  void keep(const Inverse3Message& message, std::int64_t now_us);
  void publish(std::uint32_t trouble, std::int64_t now_us);
  void runTick(std::int64_t now_us);
  [[nodiscard]] Vec3 allowedForce_N(std::int64_t now_us);

  std::unique_ptr<WebSocket> service_;  // of the thread, once there is one
  const std::string deviceId_;
  DeviceIdentity identity_;
  DeviceCapabilities capabilities_;
  const Vec3 origin_m_;  // world point of the device's origin
  std::thread thread_;
  DeviceTick tick_;
  std::atomic<bool> ending_{false};
  std::atomic<bool> inTick_{false};
  std::atomic<bool> released_{false};  // the service was sent zero, or is gone
  std::atomic<bool> forceWished_{false};
  std::atomic<std::uint32_t> drops_{0};
  LatestValue<MailedReading> readings_;
  LatestValue<MailedForce> forces_;
  LatestValue<DeviceSnapshot> snapshots_;
  SpscRing<DeviceEvent> events_;
  bool closed_ = false;
  // The device's thread.
  DeviceReading reading_;
  MailedReading published_;
  DeviceSnapshot state_;
  ForceGate gate_;
  std::int64_t begun_us_ = 0;
  std::int64_t taken_us_ = 0;  // last valid reading
  std::uint64_t forceNumber_ = 0;
  std::int64_t forceNew_us_ = 0;
  std::int64_t sent_us_ = 0;
  std::uint32_t dropsSeen_ = 0;
  std::uint64_t droppedNumber_ = 0;
  // The servo's thread.
  MailedForce wanted_;
  ReadingAge age_{kDeviceStale | kDeviceUncalibrated, 2 * kInverse3Look_us, kInverse3Lost_us};
};

/// Haply Inverse3 through its service on this computer (Inverse3Device); TORSIO_INVERSE_SERVICE names another
/// place as HOST:PORT. The name in a DeviceRequest is the device's id; "": the first one. Not confirmed on
/// hardware. Its thread runs in this process; `hosted` (sim/device/process) moves it into the device process.
[[nodiscard]] DeviceDriver inverse3Driver();
/// Opens the device as the driver does. Throws Error{kDevice} or Error{kBadParameter}.
[[nodiscard]] std::unique_ptr<HostedDevice> openInverse3(const DeviceRequest& request);

}  // namespace torsio
