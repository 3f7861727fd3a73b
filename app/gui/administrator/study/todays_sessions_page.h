// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/gui/base/awaits_calls.h"
#include "app/gui/base/page.h"
#include "app/services/devices/device_readiness.h"
#include "app/services/study/day_board.h"
#include "app/services/study/live_call.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTimer;

namespace torsio::gui {

class AlertPanel;
class Background;
class CallBar;
class DataTable;
class FoldLine;
struct Cell;
class PageHeading;

/// The board of the day: activities, remaining time, running recordings, missing sheets. Refreshes itself
/// every few seconds while visible.
class TodaysSessionsPage : public Page, public AwaitsCalls {
  Q_OBJECT

 public:
  explicit TodaysSessionsPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  bool leave() override;
  void retranslate() override;
  [[nodiscard]] bool callsGoOn() const override;

 protected:
  void customEvent(QEvent* event) override;

 private:
  void read();
  /// Rereads in the background, on the timer.
  void refresh();
  void showContent();
  void showStations();
  void swap();
  /// Plans slots for the selected trainees; for all if fewer than two are selected.
  void planDay();
  void showButtons();
  void logTime();
  void reportDeviation();
  void changeState();
  void printCallList();
  /// For the selected trainee, or everybody whose scoring is due.
  void printSheets();
  void typeSheets();
  void copyReminders();
  [[nodiscard]] const DayBoardRow* current() const;
  /// Returns the selected rows, in the order of the board.
  [[nodiscard]] std::vector<const DayBoardRow*> chosen() const;
  /// Returns the number of missing sheets; the tool tip lists other occasions the trainee was called to.
  [[nodiscard]] Cell sheetsCell(const DayBoardRow& row) const;
  [[nodiscard]] Cell slotCell(const DayBoardRow& row) const;
  [[nodiscard]] QString nowText(const DayBoardRow& row) const;
  /// Returns the result of the last device check of a station: symbol and word, never colour alone.
  [[nodiscard]] QString checkText(const StationDevice& device) const;

  void showWaiting(std::size_t toConfirm);

  std::optional<DayBoard> board_;
  std::size_t toConfirm_ = 0;
  std::vector<CalledCase> calls_;
  QTimer* clock_;
  PageHeading* heading_;
  QPushButton* waiting_;  ///< requests for a second person; leads to them
  QLabel* cohortLabel_ = nullptr;
  QComboBox* cohort_;
  QLabel* summary_;
  CallBar* callBar_;
  DataTable* table_;
  AlertPanel* alerts_;
  FoldLine* stationsLine_;
  DataTable* stations_;
  Background* reader_;
  QPushButton* plan_;
  QPushButton* print_;
  QAction* callList_;
  QAction* sheets_;
  QAction* typeIn_;
  QAction* reminders_;
  QPushButton* call_;
  QPushButton* time_;
  QPushButton* swap_;
  QPushButton* deviation_;
  QPushButton* deviations_;
  QPushButton* state_;
};

}  // namespace torsio::gui
