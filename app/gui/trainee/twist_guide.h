// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QCoreApplication>
#include <QFrame>
#include <QString>

#include "assessment/attempt/twist_count.h"
#include "assessment/domain/study/curriculum.h"
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

/// Feedback during a recording: the task, completed twists, the last release, and what to do next. Plain
/// value. GUI thread.
class TwistCoach {
  Q_DECLARE_TR_FUNCTIONS(TwistCoach)

 public:
  /// Starts a recording. `haptic`: the hand feels force; otherwise the cues name mouse and keys.
  void begin(const TrainingModule& module, double target_rad, bool haptic);
  /// Updates with the next frame.
  void follow(const LiveState& state, bool onTarget);

  [[nodiscard]] std::int64_t completed() const noexcept { return twists_.completed(); }
  /// Returns the elapsed fraction of the holding time on target; 1 or more: complete.
  [[nodiscard]] double heldShare() const noexcept { return heldShare_; }
  [[nodiscard]] QString goal() const;
  [[nodiscard]] QString count() const;
  /// Describes the last release, and what to improve.
  [[nodiscard]] QString verdict() const;
  [[nodiscard]] QString cue(const LiveState& state) const;
  /// Says whether the jaw is open, closed in the air or holds the tissue.
  [[nodiscard]] static QString jaw(const LiveState& state);

 private:
  [[nodiscard]] double heldShareOf(const LiveState& state, bool onTarget);
  [[nodiscard]] QString twistingCue(double angle_rad) const;
  [[nodiscard]] QString closedInAir() const;

  TrainingModule module_;
  double target_rad_ = 0.0;
  bool haptic_ = false;
  TwistCount twists_;
  std::int64_t released_ = 0;          // on target
  std::int64_t onTargetFrom_us_ = -1;  // start of the present stay on target; -1: not on target
  double heldShare_ = 0.0;
  bool held_ = false;       // the present twist has been held long enough
  bool letGoHeld_ = false;  // the last twist had been held long enough
};

}  // namespace torsio::gui
