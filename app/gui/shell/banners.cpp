// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/banners.h"

#include <algorithm>
#include <utility>

#include <QAccessible>
#include <QApplication>
#include <QEvent>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/gui/widgets/window_events.h"
#include "app/services/recording/station_writer.h"

namespace torsio::gui {

namespace {

constexpr int kLongest = 720;

}  // namespace

FloatingLine::FloatingLine(Edge edge, QWidget* parent) : QLabel(parent), edge_(edge) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setWordWrap(true);
  setTextFormat(Qt::PlainText);
  setAlignment(Qt::AlignCenter);
  parent->installEventFilter(this);
  hide();
}

void FloatingLine::showLine(const QString& sentence) {
  if (isVisible() && text() == sentence) {
    return;
  }
  setText(sentence);
  place();
  raise();
  show();
}

bool FloatingLine::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible()) {
    place();
  }
  return QLabel::eventFilter(watched, event);
}

void FloatingLine::place() {
  const QWidget* ground = parentWidget();
  const int widest = std::min(kLongest, ground->width() - 4 * kSpace);
  setWordWrap(false);
  const int wanted = sizeHint().width();
  setWordWrap(true);
  const int width = std::min(wanted, widest);
  const int height = heightForWidth(width);
  const int top = edge_ == Edge::kTop ? 0 : ground->height() - height - 3 * kSpace;
  setGeometry((ground->width() - width) / 2, top, width, height);
}

IdleWarning::IdleWarning(const Clock* clock, const IdleLimits& limits, QWidget* parent)
    : FloatingLine(Edge::kTop, parent), guard_(clock != nullptr ? *clock : machineClock_, limits) {
  setObjectName(QStringLiteral("idleWarning"));
  followLanguage(this, [this] { setAccessibleName(tr("Warning of the idle lock")); });
  qApp->installEventFilter(this);
}

bool IdleWarning::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::Wheel:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
      guard_.activity();
      break;
    default:
      break;
  }
  return FloatingLine::eventFilter(watched, event);
}

void IdleWarning::watch(bool watched, bool busy, End end) {
  const bool counts = watched && !busy;
  if (counts == guard_.busy()) {
    guard_.setBusy(!counts);  // each call restarts the idle timer
  }
  const IdleState state = guard_.state();
  if (!watched || state != IdleState::kWarning) {
    hide();
  }
  if (!watched) {
    return;
  }
  if (state == IdleState::kWarning) {
    const QString left = clockTimeLeft(guard_.untilLock_us());
    showLine(end == End::kSignOut
                 ? tr("Still there? You will be signed out in %1. Press any key to stay").arg(left)
                 : tr("Still there? The screen will be locked in %1. Press any key to stay").arg(left));
  } else if (state == IdleState::kLocked) {
    guard_.unlock();  // the lock follows; the timer restarts after unlocking
    Q_EMIT timeIsUp();
  }
}

AwayBanner::AwayBanner(std::function<bool()> reconnect, QWidget* parent)
    : FloatingLine(Edge::kTop, parent), reconnect_(std::move(reconnect)) {
  setObjectName(QStringLiteral("databaseAway"));
  followLanguage(this, [this] { setAccessibleName(tr("State of the database")); });
}

void AwayBanner::reset() {
  answered_ = true;
  settleDue_ = false;
}

void AwayBanner::follow(const StationWriter& line, bool running) {
  const bool answers = line.answers();
  if (answers) {
    hide();
    Q_EMIT moved(line.notice());
  } else {
    QString said = running
                       ? tr("The database does not answer. Your run continues; it is kept on this computer "
                            "and stored as soon as the database answers")
                       : tr("The database does not answer. Torsio tries again by itself; what is stored is "
                            "safe");
    if (const std::size_t waiting = line.waiting(); waiting > 0) {
      said = tr("%1. Waiting to be stored: %2").arg(said).arg(waiting);
    }
    showLine(said);
    settleDue_ = true;
  }
  answered_ = answers && (answered_ || reconnect_());
  if (answers && settleDue_ && !running) {
    Q_EMIT settleWanted();
  }
  if (const std::size_t now = line.refused(); now != refusedTold_) {
    refusedTold_ = now;
    if (now > 0) {
      Q_EMIT refused(static_cast<int>(now));
    }
  }
}

namespace {

constexpr int kShown_ms = 6000;

}  // namespace

Toast::Toast(QWidget* parent) : FloatingLine(Edge::kBottom, parent) {
  setObjectName(QStringLiteral("toast"));
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &QWidget::hide);
}

void Toast::say(const QString& sentence) {
  setAccessibleName(sentence);
  showLine(sentence);
  timer_.start(kShown_ms);
  QAccessibleEvent heard(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&heard);
}

}  // namespace torsio::gui
