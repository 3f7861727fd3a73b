// SPDX-License-Identifier: GPL-3.0-or-later
// The haptic device of SimulationController, and what happens without it.
#include <utility>

#include "app/gui/base/translated_text.h"
#include "app/gui/simulator/simulation_controller.h"
#include "app/services/devices/haptic_station.h"
#include "sim/core/error.h"

namespace torsio::gui {

void SimulationController::useHapticDevice(HapticOpener opener) {
  const bool was = static_cast<bool>(openHaptic_);
  if (was && !opener) {
    ++hapticWanted_;
    if (stage() == StageKind::kPractising) {
      takeHaptic().reset();  // immediately, because another page may open it next
      practise(nullptr);
    }
  }
  openHaptic_ = std::move(opener);
  openHaptic();
}

void SimulationController::openHaptic() {
  if (!openHaptic_ || scene() == nullptr || mode() == Mode::kReplay || !hapticModel().isEmpty()) {
    return;
  }
  workers_.start([this, ticket = ++hapticWanted_, open = openHaptic_, scene = loaded_.scene] {
    // Shared pointer, because a queued call must be copyable.
    const auto device = std::make_shared<std::unique_ptr<HapticDevice>>();
    QString problem;
    const WhileWanted wanted([this, ticket] { return ticket != hapticWanted_; });
    try {
      *device = open(*scene);
    } catch (const Error& error) {
      problem = toQString(error.happened());
    } catch (const std::exception& error) {
      problem = QString::fromUtf8(error.what());
    }
    QMetaObject::invokeMethod(
        this,
        [this, ticket, device, problem] {
          if (ticket == hapticWanted_) {
            tookHaptic(std::move(*device), problem);
          }
        },
        Qt::QueuedConnection);
  });
}

void SimulationController::tookHaptic(std::unique_ptr<HapticDevice> device, const QString& problem) {
  if (!device) {
    Q_EMIT noticed(problem.isEmpty() ? tr("No haptic device was found. You practise with mouse and keyboard")
                                     : tr("You practise with mouse and keyboard: %1").arg(problem));
    return;
  }
  const QString model = toQString(device->capabilities().model);
  const bool felt = device->capabilities().rendersForce;
  if (stage() != StageKind::kPractising) {
    return;  // released, and requested again with the next scene
  }
  practise(std::move(device));
  Q_EMIT noticed(felt ? tr("You practise with %1. The force is felt").arg(model)
                      : tr("You practise with %1. The force is shown, not felt").arg(model));
}

/// Stops free practice with the haptic device, and returns the device, which is reused because opening it
/// takes seconds. Null: there is none, or it is no longer wanted.
std::unique_ptr<HapticDevice> SimulationController::takeHaptic() {
  stage::Running* now = stage() == StageKind::kTraining ? nullptr : running();
  if (now == nullptr || !now->usesHaptic()) {
    return nullptr;
  }
  std::unique_ptr<HapticDevice> device = now->run->releaseDevice();
  return openHaptic_ ? std::move(device) : nullptr;
}

/// Closes the device in the background, which may take as long as opening it.
void SimulationController::retireHaptic(std::unique_ptr<HapticDevice> device) {
  ++hapticWanted_;
  if (!device) {
    return;
  }
  workers_.start(
      [old = std::make_shared<std::unique_ptr<HapticDevice>>(std::move(device))] { old->reset(); });
}

void SimulationController::watchDevice() {
  stage::Running* now = running();
  if (now == nullptr || !now->usesHaptic()) {
    return;
  }
  if ((now->run->latest().deviceStatus & kDeviceLost) == 0) {
    return;
  }
  auto* training = std::get_if<stage::Training>(&stage_);
  if (training == nullptr) {
    loseHaptic();
  } else if (!training->lossTold) {
    training->lossTold = true;
    Q_EMIT deviceLost();
  }
}

/// Handles the loss of the device. The servo has already set the force to zero: a lost device gets none.
void SimulationController::loseHaptic() {
  const bool recorded = stage() == StageKind::kRecording;
  if (recorded) {
    static_cast<void>(finishRun(TrialOutcome::kInterrupted));
  }
  retireHaptic(takeHaptic());
  practise(nullptr);
  Q_EMIT noticed(recorded
                     ? tr("The haptic device was disconnected. The recording up to then is kept; continue "
                          "with the mouse")
                     : tr("The haptic device was disconnected. Put it down and continue with the mouse"));
}

QString SimulationController::hapticModel() const {
  const bool free = stage() == StageKind::kPractising || stage() == StageKind::kRecording;
  const stage::Running* now = free ? running() : nullptr;
  if (now == nullptr || !now->usesHaptic()) {
    return {};
  }
  return toQString(now->run->header().deviceModel);
}

}  // namespace torsio::gui
