// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

#include "app/services/access/idle_guard.h"

namespace torsio::gui {

/// The line that warns before the idle lock. GUI thread.
class IdleWarning : public QLabel {
  Q_OBJECT

 public:
  /// What happens to an idle desk.
  enum class End { kLock, kSignOut };

  /// `clock` must outlive it; null: the system's.
  IdleWarning(const Clock* clock, const IdleLimits& limits, QWidget* parent = nullptr);

  void setLimits(const IdleLimits& limits) { guard_.setLimits(limits); }
  /// Restarts the timer on the user's activity.
  void activity() { guard_.activity(); }
  /// Call about once a second. `watched`: a desk is shown; `busy`: a run is in progress on it.
  void watch(bool watched, bool busy, End end);

 Q_SIGNALS:
  void timeIsUp();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  MonotonicClock machineClock_;
  IdleGuard guard_;
};

}  // namespace torsio::gui
