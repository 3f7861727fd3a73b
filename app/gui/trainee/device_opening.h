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

/// Opens the device of one recording off the GUI thread: its driver takes seconds, and one that hangs must
/// not take the window along. Attempts follow one another, so that the driver is asked for one thing at a
/// time. GUI thread.
class DeviceOpening : public QObject {
  Q_OBJECT

 public:
  explicit DeviceOpening(QObject* parent = nullptr);
  /// Gives up, and waits for the driver.
  ~DeviceOpening() override;

  /// `open` runs in a worker thread; then, in the GUI thread and unless cancelled, `done` with what it
  /// returned or `failed` with what it threw. Begins anew when another attempt goes on.
  void begin(std::function<std::unique_ptr<HapticDevice>()> open,
             std::function<void(std::unique_ptr<HapticDevice>)> done,
             std::function<void(const std::exception_ptr&)> failed);
  /// Nobody wants the device any more: when it comes it is given back, by the worker.
  void cancel();
  [[nodiscard]] bool going() const noexcept { return going_; }

 private:
  QThreadPool worker_;
  std::atomic<std::uint64_t> attempt_{0};  // number of the newest
  bool going_ = false;
};

}  // namespace torsio::gui
