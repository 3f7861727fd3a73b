// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/hint_line.h"

#include <algorithm>
#include <limits>

#include "app/gui/simulator/detorsion_panel.h"
#include "app/gui/simulator/readout_panel.h"
#include "app/gui/simulator/simulation_controller.h"

namespace torsio::gui {

namespace {

constexpr double kNear_m = 0.050;
constexpr double kNoticeFor_s = 6.0;

}  // namespace

HintLine::HintLine(const SimulationController& controller, const DetorsionPanel& detorsion, QWidget* parent)
    : QLabel(parent), controller_(controller), detorsion_(detorsion) {
  connect(&controller, &SimulationController::noticed, this,
          [this](const QString& sentence) { notice(sentence); });
}

void HintLine::notice(const QString& sentence, bool stays) {
  notice_ = sentence;
  noticeLeft_s_ = stays ? std::numeric_limits<double>::infinity() : kNoticeFor_s;
}

void HintLine::endNotice() {
  noticeLeft_s_ = 0.0;
}

void HintLine::show(const LiveState& state) {
  const QString said = noticeLeft_s_ > 0.0 ? notice_ : hint(state);
  if (text() != said) {
    setText(said);
  }
}

QString HintLine::hint(const LiveState& state) const {
  const SimulationController::Mode mode = controller_.mode();
  if (mode == SimulationController::Mode::kReplay) {
    return tr("Replay of a recorded run");
  }
  if (const QString untwisting = detorsion_.cue(); !untwisting.isEmpty()) {
    return untwisting;
  }
  if (mode == SimulationController::Mode::kEmpty) {
    return {};
  }
  if (!controller_.hapticModel().isEmpty()) {
    return hapticHint(state.phase);
  }
  switch (state.phase) {
    case ExercisePhase::kTracking: {
      const std::optional<SurfacePoint> near = controller_.nearby(state);
      return near && near->distance_m < kNear_m
                 ? tr("%1 mm to the surface. Wheel: closer")
                       .arg(std::max(0.0, near->distance_m) * 1000.0, 0, 'f', 0)
                 : tr("Bring the jaw to the marked band. Wheel: depth, right drag: turn the view");
    }
    case ExercisePhase::kContact:
      return tr("Touching. Hold the left button or Space to grip");
    case ExercisePhase::kTwisting:
      return tr("Holding. Drag, or press Q and E, to twist; release the button to open the jaw");
    case ExercisePhase::kReleased:
      return ReadoutPanel::releaseText(state);
  }
  return {};
}

QString HintLine::hapticHint(ExercisePhase phase) const {
  const bool led = !controller_.toolRidesOnTissue();  // a stylus; otherwise the tool turns on the spot
  switch (phase) {
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

}  // namespace torsio::gui
