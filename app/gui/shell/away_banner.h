// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include <QLabel>

namespace torsio {
class StationWriter;
}

namespace torsio::gui {

/// Says calmly that the database does not answer, and what becomes of the work meanwhile; asks for what had
/// to wait once it answers again. GUI thread.
class AwayBanner : public QLabel {
  Q_OBJECT

 public:
  /// `reconnect` brings the connection of the pages back; false: not yet.
  explicit AwayBanner(std::function<bool()> reconnect, QWidget* parent = nullptr);

  /// A new line: nothing is known to wait.
  void reset();
  /// About once a second. `running`: a run goes on.
  void follow(const StationWriter& line, bool running);
  /// Recordings may wait in files.
  void setSettleDue(bool due) noexcept { settleDue_ = due; }

 Q_SIGNALS:
  /// The database will never take this many entries of the station.
  void refused(int entries);
  void settleWanted();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  std::function<bool()> reconnect_;
  std::size_t refusedTold_ = 0;
  bool answered_ = true;  // at the last look
  bool settleDue_ = false;
};

}  // namespace torsio::gui
