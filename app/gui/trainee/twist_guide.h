// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "sim/core/live_types.h"

class QLabel;
class QPushButton;

namespace torsio::gui {

/// A first twist, movement by movement: a card over the organ that names the next one and waits until it is
/// done. GUI thread.
class TwistGuide : public QFrame {
  Q_OBJECT

 public:
  enum class Step { kReach, kClose, kTurn, kHold, kLetGo, kDone };
  static constexpr int kMovements = 5;  ///< before kDone; one less where nothing is to be held

  /// Stands in the upper left corner of `over`, hidden until begin().
  explicit TwistGuide(QWidget* over);

  /// Shows the first movement. `haptic`: the hand feels force; else mouse and keys are named. `held`: the
  /// exercise asks to hold the target for a while.
  void begin(bool haptic, bool held);
  void end();
  /// Looks whether the movement is done. `heldShare`: how much of the time to be held is over, 0 to 1.
  void follow(const LiveState& state, bool onTarget, double heldShare);
  [[nodiscard]] bool going() const noexcept { return going_; }
  [[nodiscard]] Step step() const noexcept { return step_; }
  void retranslate();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] Step next(const LiveState& state, bool onTarget, double heldShare) const;
  void showStep();
  void place();

  Step step_ = Step::kReach;
  bool going_ = false;
  bool haptic_ = false;
  bool held_ = false;
  bool lost_ = false;  ///< let go before the target was held
  QLabel* number_;
  QLabel* what_;
  QLabel* how_;
  QPushButton* skip_;
};

}  // namespace torsio::gui
