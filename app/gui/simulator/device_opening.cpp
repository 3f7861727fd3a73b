// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/device_opening.h"

#include <utility>

#include "app/services/devices/haptic_station.h"

namespace torsio::gui {

DeviceOpening::DeviceOpening(QObject* parent) : QObject(parent) {
  worker_.setMaxThreadCount(1);
}

DeviceOpening::~DeviceOpening() {
  ++attempt_;
  worker_.clear();
  worker_.waitForDone();
}

void DeviceOpening::begin(std::function<std::unique_ptr<HapticDevice>()> open,
                          std::function<void(std::unique_ptr<HapticDevice>)> done,
                          std::function<void(const std::exception_ptr&)> failed) {
  going_ = true;
  worker_.start([this, attempt = ++attempt_, open = std::move(open), done = std::move(done),
                 failed = std::move(failed)] {
    // Shared pointer, because a queued call must be copyable.
    const auto device = std::make_shared<std::unique_ptr<HapticDevice>>();
    std::exception_ptr problem;
    const WhileWanted wanted([this, attempt] { return attempt != attempt_; });
    try {
      *device = open();
    } catch (...) {
      problem = std::current_exception();
    }
    QMetaObject::invokeMethod(
        this,
        [this, attempt, device, problem, done, failed] {
          if (attempt != attempt_) {
            worker_.start([device] { device->reset(); });
            return;
          }
          going_ = false;
          if (problem) {
            failed(problem);
          } else {
            done(std::move(*device));
          }
        },
        Qt::QueuedConnection);
  });
}

void DeviceOpening::cancel() {
  ++attempt_;
  going_ = false;
}

void DeviceOpening::retire(std::unique_ptr<HapticDevice> device) {
  cancel();
  if (device) {
    worker_.start(
        [old = std::make_shared<std::unique_ptr<HapticDevice>>(std::move(device))] { old->reset(); });
  }
}

}  // namespace torsio::gui
