// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QString>

#include "sim/core/live_types.h"

namespace torsio::gui {

class DetorsionPanel;
class SimulationController;

/// The line at the foot of free practice: what can be done next, or temporarily what has just happened.
class HintLine : public QLabel {
  Q_OBJECT

 public:
  /// `controller` and `detorsion` must outlive the line.
  HintLine(const SimulationController& controller, const DetorsionPanel& detorsion,
           QWidget* parent = nullptr);

  /// Shows a notice for some seconds; `stays`: until endNotice().
  void notice(const QString& sentence, bool stays = false);
  void endNotice();
  void pass(double elapsed_s) noexcept { noticeLeft_s_ -= elapsed_s; }
  void show(const LiveState& state);

 private:
  [[nodiscard]] QString hint(const LiveState& state) const;
  [[nodiscard]] QString hapticHint(ExercisePhase phase) const;

  const SimulationController& controller_;
  const DetorsionPanel& detorsion_;
  QString notice_;
  double noticeLeft_s_ = 0.0;
};

}  // namespace torsio::gui
