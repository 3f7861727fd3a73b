// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include "sim/core/live_types.h"

class QLabel;

namespace torsio::gui {

class AngleDial;
class Card;
class LevelBar;
struct Theme;

/// Limits shown beside the tissue's state.
struct ReadoutLimits {
  double tolerance_rad = 0.0;
  double force_N = 0.0;    ///< 0: unknown
  double torque_Nm = 0.0;  ///< 0: unknown
};

/// Angle, torque, force, phase and timing as numbers, unobtrusive until something needs attention.
class ReadoutPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ReadoutPanel(QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  void setLimits(const ReadoutLimits& limits);
  /// `framesPerSecond`: 0 if unknown.
  void show(const LiveState& state, double framesPerSecond);

  void retranslate();

  /// Name of a phase in the user's language.
  [[nodiscard]] static QString phaseName(ExercisePhase phase);
  /// Explains in a sentence why the organ was released: the hand opened, the jaw slipped, the tissue would
  /// have folded.
  [[nodiscard]] static QString releaseText(const LiveState& state);
  /// Returns whether the instrument presses the free organ further in than it should.
  [[nodiscard]] static bool pressesTooDeep(const LiveState& state);

 private:
  void showPhase(ExercisePhase phase);
  void showTiming(const LiveState& state, double framesPerSecond);

  const Theme* theme_;
  ReadoutLimits limits_;
  LiveState shown_;
  double rate_ = 0.0;
  Card* twist_;
  Card* load_;
  Card* timing_;
  AngleDial* dial_;
  QLabel* phase_;
  LevelBar* torque_;
  LevelBar* force_;
  QLabel* tickName_;
  QLabel* framesName_;
  QLabel* tick_;
  QLabel* frames_;
};

}  // namespace torsio::gui
