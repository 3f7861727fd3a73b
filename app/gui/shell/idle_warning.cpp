// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/idle_warning.h"

#include <QEvent>

#include "app/gui/base/clock_time.h"

namespace torsio::gui {

IdleWarning::IdleWarning(const Clock* clock, const IdleLimits& limits, QWidget* parent)
    : QLabel(parent), guard_(clock != nullptr ? *clock : machineClock_, limits) {
  setObjectName(QStringLiteral("idleWarning"));
  setAccessibleName(tr("Warning of the idle lock"));
  setAlignment(Qt::AlignCenter);
  hide();
}

void IdleWarning::watch(bool watched, bool busy, End end) {
  const bool counts = watched && !busy;
  if (counts == guard_.busy()) {
    guard_.setBusy(!counts);  // each call restarts the idle timer
  }
  const IdleState state = guard_.state();
  setVisible(watched && state == IdleState::kWarning);
  if (!watched) {
    return;
  }
  if (state == IdleState::kWarning) {
    const QString left = clockTimeLeft(guard_.untilLock_us());
    setText(end == End::kSignOut
                ? tr("Still there? You will be signed out in %1. Press any key to stay").arg(left)
                : tr("Still there? The screen will be locked in %1. Press any key to stay").arg(left));
  } else if (state == IdleState::kLocked) {
    guard_.unlock();  // the lock follows; the timer restarts after unlocking
    Q_EMIT timeIsUp();
  }
}

void IdleWarning::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    setAccessibleName(tr("Warning of the idle lock"));
  }
  QLabel::changeEvent(event);
}

}  // namespace torsio::gui
