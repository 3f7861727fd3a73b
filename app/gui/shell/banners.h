// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include <QLabel>
#include <QTimer>

#include "app/services/access/boot_clock.h"
#include "app/services/access/idle_guard.h"
#include "sim/core/text.h"

namespace torsio {
class StationWriter;
}

namespace torsio::gui {

/// A line above an edge of its parent, over the other content, so that nothing moves under the pointer.
/// Clicks go to what is below it. GUI thread.
class FloatingLine : public QLabel {
  Q_OBJECT

 public:
  enum class Edge { kTop, kBottom };
  FloatingLine(Edge edge, QWidget* parent);

 protected:
  /// Shows the line with this text.
  void showLine(const QString& sentence);
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  Edge edge_;
};

/// The line that warns before the idle lock. GUI thread.
class IdleWarning : public FloatingLine {
  Q_OBJECT

 public:
  /// What happens to an idle desk.
  enum class End { kLock, kSignOut };

  /// `clock` must outlive it; null: the system's.
  IdleWarning(const Clock* clock, const IdleLimits& limits, QWidget* parent = nullptr);

  void setLimits(const IdleLimits& limits) { guard_.setLimits(limits); }
  /// Call about once a second. `watched`: a desk is shown; `busy`: a run is in progress on it, or
  /// it waits for calls.
  void watch(bool watched, bool busy, End end);

 Q_SIGNALS:
  void timeIsUp();

 protected:
  /// Restarts the timer on the user's activity anywhere.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  BootClock machineClock_;
  IdleGuard guard_;
};

/// Shows a database outage and its consequences for the present work; tells whether the record has moved;
/// requests the deferred tasks when the database answers again. GUI thread.
class AwayBanner : public FloatingLine {
  Q_OBJECT

 public:
  /// `reconnect`: restores the connection of the pages; false: not yet.
  explicit AwayBanner(std::function<bool()> reconnect, QWidget* parent = nullptr);

  /// Resets for a new writer: nothing is known to be waiting.
  void reset();
  /// Call about once a second. `running`: a run is in progress.
  void follow(const StationWriter& line, bool running);
  /// Sets whether recordings may be waiting in files.
  void setSettleDue(bool due) noexcept { settleDue_ = due; }

 Q_SIGNALS:
  /// The database has permanently rejected this number of the station's entries.
  void refused(int entries);
  void settleWanted();
  /// At each check: where the record has moved; empty: it is the living one.
  void moved(const Text& notice);

 private:
  std::function<bool()> reconnect_;
  std::size_t refusedTold_ = 0;
  bool answered_ = true;  // at the last check
  bool settleDue_ = false;
};

/// A message at the lower edge of its parent that disappears by itself.
class Toast : public FloatingLine {
  Q_OBJECT

 public:
  explicit Toast(QWidget* parent);
  void say(const QString& sentence);

 private:
  QTimer timer_;
};

}  // namespace torsio::gui
