// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

#include "app/services/access/idle_guard.h"

namespace torsio::gui {

/// The line that warns of the idle lock. GUI thread.
class IdleWarning : public QLabel {
  Q_OBJECT

 public:
  /// What happens to a desk when its time is up.
  enum class End { kLock, kSignOut };

  /// `clock` outlives it; null: the machine's.
  IdleWarning(const Clock* clock, const IdleLimits& limits, QWidget* parent = nullptr);

  void setLimits(const IdleLimits& limits) { guard_.setLimits(limits); }
  /// Somebody is there.
  void activity() { guard_.activity(); }
  /// About once a second. `watched`: a desk is shown; `busy`: a run goes on at it.
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
