// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/core/text.h"
#include "sim/device/device_driver.h"
#include "sim/device/hdapi/hdapi_library.h"
#include "sim/device/hosted_device.h"

namespace torsio {

/// The newest value of one writer for one reader in memory that two processes share. The writer never waits;
/// the reader tries a few times, then keeps its old value: a writer that died while writing blocks nothing.
template <typename T>
class SharedValue {
  static_assert(std::is_trivially_copyable_v<T>);
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

 public:
  /// Writer's thread.
  void publish(const T& value) noexcept {
    Words words{};
    std::memcpy(words.data(), &value, sizeof(T));
    const std::uint64_t begun = sequence_.load(std::memory_order_relaxed) + 1;
    sequence_.store(begun, std::memory_order_relaxed);
    // Who sees a new word sees that writing had begun. Without a fence, which ThreadSanitizer does not know.
    for (std::size_t i = 0; i < kWords; ++i) {
      words_[i].store(words[i], std::memory_order_release);
    }
    sequence_.store(begun + 1, std::memory_order_release);
  }
  /// Returns the newest value, empty when there is none yet or the writer was writing all the while. Any
  /// thread.
  [[nodiscard]] std::optional<T> latest() const noexcept {
    constexpr int kTries = 64;
    for (int i = 0; i < kTries; ++i) {
      const std::uint64_t before = sequence_.load(std::memory_order_acquire);
      if (before == 0 || (before & 1U) != 0) {
        continue;
      }
      Words words{};
      for (std::size_t k = 0; k < kWords; ++k) {
        words[k] = words_[k].load(std::memory_order_acquire);
      }
      if (sequence_.load(std::memory_order_relaxed) == before) {
        T value;
        std::memcpy(static_cast<void*>(&value), words.data(), sizeof(T));
        return value;
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kWords = (sizeof(T) + 7) / 8;
  using Words = std::array<std::uint64_t, kWords>;

  std::atomic<std::uint64_t> sequence_{0};
  std::array<std::atomic<std::uint64_t>, kWords> words_{};
};

/// Events of one writer for one reader in memory that two processes share. Neither ever waits; a reader that
/// comes too late misses the oldest.
template <typename T, std::size_t Capacity>
class SharedEvents {
 public:
  /// Writer's thread.
  void publish(const T& event) noexcept {
    const std::uint64_t number = published_.load(std::memory_order_relaxed);
    slots_[number % Capacity].publish(event);
    published_.store(number + 1, std::memory_order_release);
  }
  /// Takes the event after the `taken` ones and counts it there; false when there is none. Reader's thread.
  [[nodiscard]] bool next(std::uint64_t& taken, T& event) const noexcept {
    const std::uint64_t published = published_.load(std::memory_order_acquire);
    if (published - taken > Capacity) {
      taken = published - Capacity;
    }
    while (taken < published) {
      if (const std::optional<T> found = slots_[taken++ % Capacity].latest()) {
        event = *found;
        return true;
      }
    }
    return false;
  }

 private:
  std::atomic<std::uint64_t> published_{0};
  std::array<SharedValue<T>, Capacity> slots_{};
};

/// Version of the memory that the program and its device process share: both are installed together, and a
/// device process of another build refuses to work.
inline constexpr std::uint32_t kChannelVersion = 4;
/// File number under which the device process finds the shared memory.
inline constexpr int kChannelFile = 3;
/// File number of the pipe whose other end the program holds: when it is closed, the program is gone.
inline constexpr int kParentFile = 4;
/// Time without a call of the driver's servo after which the device process lets go by itself: the motors
/// have their zero 20 ms after the last frame.
inline constexpr std::int64_t kChildLetsGo_us = 15'000;
/// Time without one after which the program ends the device process and reports the device lost.
inline constexpr std::int64_t kChildEnded_us = 100'000;

/// Time for a second device process to let go of what the first one left.
inline constexpr std::int64_t kSecondHand_us = 3'000'000;
/// Variable of the device process's environment, by which whatever it starts is known.
inline constexpr const char* kRunVariable = "TORSIO_DEVICE_RUN";

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
  bool onlyLook = false;   ///< look whether it could be opened, open nothing
  bool onlyLetGo = false;  ///< send zero, switch the output off and close: another process left the device
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
  std::atomic<bool> silent{false};    ///< the force output is off for good
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

/// The device process's tick: between a driver's reading and its force, the one goes into the shared memory
/// and the other comes from there. The driver's thread; no allocation, no lock.
struct DeviceRelay {
  DeviceChannel* channel = nullptr;
  HapticDevice* device = nullptr;
  std::uint64_t seenForce = 0;
  std::uint32_t seenDrops = 0;

  void tick(std::int64_t time_us) noexcept {
    const std::uint64_t number = channel->frames.load(std::memory_order_relaxed) + 1;
    channel->reading.publish({device->read(time_us), number});
    channel->frames.store(number, std::memory_order_release);
    device->enableForce(channel->forceWished.load(std::memory_order_relaxed));
    const std::uint32_t drops = channel->drops.load(std::memory_order_relaxed);
    if (drops != seenDrops) {
      seenDrops = drops;
      device->dropForce();
    }
    const std::optional<MailedForce> force = channel->force.latest();
    if (force && force->number != seenForce) {  // one that is not renewed expires in the driver
      seenForce = force->number;
      device->write({force->force_N, 0});
    }
  }
};

}  // namespace torsio
