// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/text.h"
#include "sim/device/device_driver.h"
#include "sim/device/device_mail.h"
#include "sim/device/hdapi/hdapi_library.h"
#include "sim/device/process/shared_value.h"

namespace torsio {

/// Version of the memory that the program and its device process share: both are installed together, and a
/// device process of another build refuses to work.
inline constexpr std::uint32_t kChannelVersion = 3;
/// File number under which the device process finds the shared memory.
inline constexpr int kChannelFile = 3;
/// File number of the pipe whose other end the program holds: when it is closed, the program is gone.
inline constexpr int kParentFile = 4;
/// Time without a call of the driver's servo after which the device process lets go by itself: the motors
/// have their zero 20 ms after the last frame.
inline constexpr std::int64_t kChildLetsGo_us = 15'000;
/// Time without one after which the program ends the device process and reports the device lost.
inline constexpr std::int64_t kChildEnded_us = 100'000;

/// How far the device process has come.
enum class ChannelStage : std::uint32_t { kStarting, kLooked, kRefused, kOpened, kServing, kServoRefused };

/// What the program asks for. Fixed sizes: nothing here may point anywhere.
struct ChannelRequest {
  std::array<char, 32> driver{};  ///< DeviceDriver::id
  std::array<char, 1024> library{};
  std::array<char, 256> deviceName{};
  Quat deviceToWorld;
  Vec3 workspaceCentre_m;
  double stylusTip_m = 0.0;
  bool onlyLook = false;  ///< look whether it could be opened, open nothing
};

/// The memory itself, created zeroed by the program.
struct DeviceChannel {
  std::uint32_t version = kChannelVersion;
  std::uint32_t size = sizeof(DeviceChannel);
  ChannelRequest request;
  std::atomic<ChannelStage> stage{ChannelStage::kStarting};
  /// Texts of the answer (ChannelReport), complete before `stage` says that there is one.
  std::array<char, 32'768> report{};
  std::uint32_t reportLength = 0;
  std::atomic<bool> serveAsked{false};
  std::atomic<bool> closeAsked{false};
  std::atomic<bool> released{false};  ///< the driver let go of the device
  std::atomic<bool> forceWished{false};
  std::atomic<std::uint32_t> drops{0};   ///< counts requests to let go at once
  std::atomic<std::uint64_t> frames{0};  ///< counts calls of the driver's servo
  SharedValue<MailedReading> reading;
  SharedValue<MailedForce> force;
  SharedValue<DeviceSnapshot> snapshot;
  SharedEvents<DeviceEvent, 256> events;
};

/// What the device process found, in words.
struct ChannelReport {
  HdapiLibrary library;     ///< of a driver that needs one, without the functions
  DriverFinding finding{};  ///< of any other, when it was only looked for
  Text happened;            ///< of an Error, else empty
  Text where;
  Text remedy;
  DeviceCapabilities capabilities;
  DeviceIdentity identity;
};

/// Writes and reads a report as bytes. A report that cannot be read is empty; sizes are checked.
[[nodiscard]] std::string packed(const ChannelReport& report);
[[nodiscard]] ChannelReport unpacked(const std::string& bytes);

}  // namespace torsio
