// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <sys/types.h>

#include "sim/core/text.h"
#include "sim/device/process/device_channel.h"

namespace torsio {

/// Throws Error{kDevice} with this sentence.
[[noreturn]] void refuseDevice(const Text& sentence, const Text& remedy);

/// The device process and the memory shared with it. What a library prints there goes to the file that
/// TORSIO_DEVICE_OUTPUT names, else nowhere. One thread at a time, but for channel().
class DeviceChild {
 public:
  /// Starts the process. Throws Error{kDevice}.
  explicit DeviceChild(const ChannelRequest& request);
  ~DeviceChild();
  DeviceChild(const DeviceChild&) = delete;
  DeviceChild& operator=(const DeviceChild&) = delete;

  [[nodiscard]] DeviceChannel& channel() noexcept { return *channel_; }
  /// Tells whether the process is gone; then what it had started is ended, too.
  [[nodiscard]] bool gone() noexcept;
  /// Tells whether a signal stopped the process.
  [[nodiscard]] bool stopped() noexcept;
  /// Ends the process at once, and whatever it had started.
  void end() noexcept;

  /// Waits until the process leaves this stage; ends it after `patience` or when cancelled. Throws
  /// Error{kDevice}.
  [[nodiscard]] ChannelStage leaves(ChannelStage from, std::chrono::microseconds patience,
                                    const std::function<bool()>& cancelled);
  [[nodiscard]] ChannelReport report() const;

 private:
  void start(int memory, int parentEnd);
  void endOrphans() const noexcept;

  int ours_ = -1;  // closed: the program is gone
  DeviceChannel* channel_ = nullptr;
  pid_t process_ = -1;
  std::string run_;  // kRunVariable=...
};

}  // namespace torsio
