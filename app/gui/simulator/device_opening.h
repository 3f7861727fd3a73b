// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>

#include <QObject>
#include <QThreadPool>

#include "sim/device/haptic_device.h"

namespace torsio::gui {

/// Opens and closes a haptic device off the GUI thread: its driver takes seconds, and a hanging one must not
/// block the window. Attempts run one after another, so that the driver does one thing at a time. GUI thread.
class DeviceOpening : public QObject {
  Q_OBJECT

 public:
  explicit DeviceOpening(QObject* parent = nullptr);
  /// Cancels, and waits for the driver.
  ~DeviceOpening() override;

  /// Runs `open` in a worker thread; then, in the GUI thread and unless cancelled, `done` with its result or
  /// `failed` with its exception. Supersedes a running attempt.
  void begin(std::function<std::unique_ptr<HapticDevice>()> open,
             std::function<void(std::unique_ptr<HapticDevice>)> done,
             std::function<void(const std::exception_ptr&)> failed);
  /// Cancels: the worker releases the device when it is open.
  void cancel();
  /// Cancels, and closes a device that is open.
  void retire(std::unique_ptr<HapticDevice> device);
  [[nodiscard]] bool going() const noexcept { return going_; }

 private:
  QThreadPool worker_;
  std::atomic<std::uint64_t> attempt_{0};  // number of the latest attempt
  bool going_ = false;
};

}  // namespace torsio::gui
