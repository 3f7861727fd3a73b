// SPDX-License-Identifier: GPL-3.0-or-later
// Of SimulationController: the haptic device, and what happens without it.
#include <utility>

#include "app/gui/simulator/simulation_controller.h"
#include "sim/base/error.h"

namespace torsio::gui {

void SimulationController::useHapticDevice(HapticOpener opener) {
  const bool was = static_cast<bool>(openHaptic_);
  if (was && !opener) {
    ++hapticWanted_;
    if (mode_ == Mode::kPractice && run_) {
      endRun();
      haptic_.reset();  // another page may open it right away
      openHaptic_ = nullptr;
      practise();
    }
    haptic_.reset();
    setHapticModel({});
  }
  openHaptic_ = std::move(opener);
  openHaptic();
}

void SimulationController::openHaptic() {
  if (!openHaptic_ || scene() == nullptr || mode_ == Mode::kReplay || !hapticModel_.isEmpty()) return;
  workers_.start([this, ticket = ++hapticWanted_, open = openHaptic_, scene = loaded_.scene] {
    // In a box, because a queued call must be copyable.
    const auto device = std::make_shared<std::unique_ptr<HapticDevice>>();
    QString problem;
    try {
      *device = open(*scene);
    } catch (const Error& error) {
      problem = QString::fromStdString(error.happened());
    } catch (const std::exception& error) {
      problem = QString::fromUtf8(error.what());
    }
    QMetaObject::invokeMethod(
        this,
        [this, ticket, device, problem] {
          if (ticket == hapticWanted_) tookHaptic(std::move(*device), problem);
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
  const QString model = QString::fromStdString(device->capabilities().model);
  if (mode_ != Mode::kPractice || frozen_)
    return;  // it is given back, and asked for again with the next scene
  haptic_ = std::move(device);
  run_.reset();
  practise();
  setHapticModel(model);
  Q_EMIT noticed(tr("You practise with %1. The force is felt").arg(model));
}

/// Its workspace lies about the old scene.
void SimulationController::retireHaptic() {
  ++hapticWanted_;
  if (haptic_) {
    workers_.start(
        [old = std::make_shared<std::unique_ptr<HapticDevice>>(std::move(haptic_))] { old->reset(); });
  }
  led_ = false;
  setHapticModel({});
}

void SimulationController::watchDevice() {
  if (!led_ || !run_ || lostSaid_) return;
  if ((run_->latest().deviceStatus & kDeviceLost) == 0) return;
  lostSaid_ = true;
  if (openHaptic_) {
    loseHaptic();
  } else {
    Q_EMIT deviceLost();
  }
}

/// The servo has set the force to zero already: a lost device gets none.
void SimulationController::loseHaptic() {
  const bool recorded = mode_ == Mode::kRecording;
  if (recorded) {
    try {
      static_cast<void>(run_->finish(TrialOutcome::kInterrupted));
    } catch (...) {
      report(std::current_exception());
    }
  }
  endRun();
  retireHaptic();
  practise();
  setMode(Mode::kPractice);
  Q_EMIT noticed(recorded ? tr("The haptic device was lost. The recording until then is kept; you go on with "
                               "the mouse")
                          : tr("The haptic device was lost. Its force is off; you go on with the mouse"));
}

void SimulationController::setHapticModel(const QString& model) {
  if (model == hapticModel_) return;
  hapticModel_ = model;
  Q_EMIT hapticModelChanged();
}

}  // namespace torsio::gui
