// SPDX-License-Identifier: GPL-3.0-or-later
// What the line at the foot of the window says: what can be done next.
#include <algorithm>
#include <cmath>

#include <QLabel>

#include "app/gui/base/clock_time.h"
#include "app/gui/practice/simulator_window.h"
#include "app/gui/simulator/detorsion_panel.h"
#include "app/gui/simulator/readout_panel.h"

namespace torsio::gui {

namespace {

constexpr double kNear_m = 0.050;

}  // namespace

QString SimulatorWindow::hapticHint(const LiveState& state) const {
  const bool led = !controller_->toolRidesOnTissue();  // a stylus; else it turns on the spot
  switch (state.phase) {
    case ExercisePhase::kTracking:
      return tr("Bring the jaw to the marked band");
    case ExercisePhase::kContact:
      return led ? tr("Touching. Hold the first button of the stylus to grip")
                 : tr("Touching. Close the jaw to grip");
    case ExercisePhase::kTwisting:
      return led ? tr("Holding. Move the stylus round to twist; release the button to open the jaw")
                 : tr("Holding. Turn the jaw to twist; open it to release");
    case ExercisePhase::kReleased:
      break;
  }
  return tr("The tissue returns to rest");
}

void SimulatorWindow::showHint(const LiveState& state) {
  const SimulationController::Mode mode = controller_->mode();
  QString text;
  if (noticeLeft_s_ > 0.0) {
    text = notice_;
  } else if (mode == SimulationController::Mode::kReplay) {
    text = tr("Replay of a recorded run");
  } else if (const QString untwisting = detorsion_->cue(); !untwisting.isEmpty()) {
    text = untwisting;
  } else if (mode != SimulationController::Mode::kEmpty && !controller_->hapticModel().isEmpty()) {
    text = hapticHint(state);
  } else if (mode != SimulationController::Mode::kEmpty) {
    switch (state.phase) {
      case ExercisePhase::kTracking: {
        const std::optional<SurfacePoint> near = controller_->nearby(state);
        text = near && near->distance_m < kNear_m
                   ? tr("%1 mm to the surface. Wheel: closer")
                         .arg(std::max(0.0, near->distance_m) * 1000.0, 0, 'f', 0)
                   : tr("Bring the jaw to the marked band. Wheel: depth, right drag: turn the view");
        break;
      }
      case ExercisePhase::kContact:
        text = tr("Touching. Hold the left button or Space to grip");
        break;
      case ExercisePhase::kTwisting:
        text = tr("Holding. Drag, or press Q and E, to twist; release the button to open the jaw");
        break;
      case ExercisePhase::kReleased:
        text = ReadoutPanel::releaseText(state);
        break;
    }
  }
  if (hint_->text() != text) {
    hint_->setText(text);
  }
  if (mode == SimulationController::Mode::kRecording) {
    recordingTime_->setText(
        tr("\u25cf Recording  %1").arg(clockTime(std::llround(1e6 * controller_->recorded_s()))));
  }
}

}  // namespace torsio::gui
