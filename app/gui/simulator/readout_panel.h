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

/// What cannot be read off the tissue's state but belongs beside it.
struct ReadoutLimits {
  double tolerance_rad = 0.0;
  double force_N = 0.0;    ///< 0: none known
  double torque_Nm = 0.0;  ///< 0: none known
};

/// Angle, torque, force, phase and timing as figures, quiet until something asks for attention.
class ReadoutPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ReadoutPanel(QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  void setLimits(const ReadoutLimits& limits);
  /// `framesPerSecond`: 0 while not known.
  void show(const LiveState& state, double framesPerSecond);

  void retranslate();

  /// Name of a phase in the user's language.
  [[nodiscard]] static QString phaseName(ExercisePhase phase);
  /// Says why the organ was let go, in a sentence: the hand opened, the jaw slipped, the tissue would have
  /// folded.
  [[nodiscard]] static QString releaseText(const LiveState& state);

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
