// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include <QLabel>

namespace torsio {
class StationWriter;
}

namespace torsio::gui {

/// Shows a database outage and its consequences for the present work; requests the deferred tasks when the
/// database answers again. GUI thread.
class AwayBanner : public QLabel {
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

 protected:
  void changeEvent(QEvent* event) override;

 private:
  std::function<bool()> reconnect_;
  std::size_t refusedTold_ = 0;
  bool answered_ = true;  // at the last check
  bool settleDue_ = false;
};

}  // namespace torsio::gui
