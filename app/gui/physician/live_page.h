// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QTimer>

#include "app/gui/base/awaits_calls.h"
#include "app/gui/base/page.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/review_queue.h"
#include "app/services/review/sheet_editor.h"
#include "assessment/domain/ids.h"

class QButtonGroup;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace torsio::gui {

class Background;
class PageHeading;
class SheetEditorPanel;

/// The sheet for the real arm, which opens automatically when an administrator calls a case; with timer and
/// targets for fingers. A started sheet is never replaced: the next call waits beside it.
class LivePage : public Page, public AwaitsCalls {
  Q_OBJECT

 public:
  explicit LivePage(ShellContext& shell, QWidget* parent = nullptr);
  ~LivePage() override;

  void enter(const QVariant& argument) override;
  [[nodiscard]] bool leave() override;
  [[nodiscard]] std::vector<std::pair<QString, QString>> keys() const override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;
  [[nodiscard]] bool callsGoOn() const override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void customEvent(QEvent* event) override;

 private:
  void createClock(QVBoxLayout* column);
  void readLines();
  /// Polls for calls in the background, on the timer.
  void lookForCalls();
  /// Opens the sheet of the newest open call, unless another one is started.
  void followCall();
  [[nodiscard]] QString stateText(const QueueLine& line) const;
  void showLines();
  void openLine(const AssignmentId& assignmentId);
  void edited();
  void toggleClock();
  void showClock();
  void writeTime();
  void submit();
  void amend();
  void showAll();
  [[nodiscard]] QString savedText() const;

  PageHeading* heading_;
  QVBoxLayout* order_;
  QButtonGroup* group_;
  QLabel* case_;
  QLabel* clock_;
  QPushButton* start_;
  QPushButton* write_;
  QPushButton* submit_;
  QPushButton* amend_;
  QPushButton* older_;
  SaidLine said_;
  SaidLine called_;
  Background* reader_;
  SheetEditorPanel* sheet_;
  std::vector<QueueLine> lines_;
  OpenedSheet opened_;
  QTimer tick_;
  QTimer follow_;
  QElapsedTimer running_;
  std::int64_t clocked_us_ = 0;
  KeptAt keptAt_ = KeptAt::kThisMachine;
  AssignmentId followed_;  // opened by a call; a user who returns to another sheet stays there
  bool withOlder_ = false;
};

}  // namespace torsio::gui
