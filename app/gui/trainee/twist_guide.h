// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "sim/core/live_types.h"

class QLabel;
class QPushButton;

namespace torsio::gui {

/// Guides a first twist movement by movement: a card over the organ that names the next movement and waits
/// until it is done. GUI thread.
class TwistGuide : public QFrame {
  Q_OBJECT

 public:
  enum class Step { kReach, kClose, kTurn, kHold, kLetGo, kDone };
  static constexpr int kMovements = 5;  ///< before kDone; one less without holding

  /// Placed in the upper left corner of `over`, hidden until begin().
  explicit TwistGuide(QWidget* over);

  /// Shows the first movement. `haptic`: the hand feels force; otherwise names mouse and keys. `held`: the
  /// exercise requires holding the target.
  void begin(bool haptic, bool held);
  void end();
  /// Checks whether the movement is done. `heldShare`: elapsed fraction of the holding time, 0 to 1.
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
  bool lost_ = false;  ///< released before the target was held
  QLabel* number_;
  QLabel* what_;
  QLabel* how_;
  QPushButton* skip_;
};

}  // namespace torsio::gui
