// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QStringList>
#include <QWidget>

#include "app/services/study/day_board.h"
#include "app/services/study/live_call.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;

namespace torsio::gui {

class ShellContext;

/// Calls trainees to the real arm, by code or scanner, and shows the cases being scored and the late sheets:
/// one line that expands.
class CallBar : public QWidget {
  Q_OBJECT

 public:
  explicit CallBar(ShellContext& shell, QWidget* parent);

  /// `occasions`: of the cohort, for calls that are not due.
  void setCohort(const CohortId& cohortId, const Occasions& occasions);
  void showCalls(const std::vector<CalledCase>& calls);
  /// Calls this trainee as if the code had been typed.
  void call(const EnrolmentId& enrolmentId);
  void retranslate();

 Q_SIGNALS:
  /// A call began or ended.
  void changed();

 private:
  void callTyped();
  void orSayWhyNot(const std::function<void()>& act);
  void copyReminder(const CalledCase& called);
  void addLine(int row, const CalledCase& called);
  [[nodiscard]] QString lineText(const CalledCase& called, const QString& codes) const;
  /// Shows one line, or up to kLinesSeen when unfolded.
  void fold();

  ShellContext& shell_;
  CohortId cohortId_;
  std::vector<CalledCase> calls_;
  QLabel* codeLabel_ = nullptr;
  QLineEdit* code_;
  QLabel* occasionLabel_ = nullptr;
  QComboBox* occasion_;
  QLabel* roomLabel_ = nullptr;
  QLineEdit* room_;
  QPushButton* call_;
  QLabel* refused_;  // why a call was refused; goes with the next change of the calls
  QGridLayout* lines_;
  QScrollArea* scroll_;
  QPushButton* more_;
  std::vector<QWidget*> shown_;
  QStringList lineTexts_;  // present texts of the lines
  bool open_ = false;
};

class FoldLine;

/// Alerts of the day: one line with the number of each kind, which expands to a scrolling list. Hidden if
/// there are none.
class AlertPanel : public QWidget {
 public:
  explicit AlertPanel(QWidget* parent);

  void showAlerts(const std::vector<DayAlert>& alerts);
  void retranslate();

 private:
  [[nodiscard]] QString textOf(const DayAlert& alert) const;

  FoldLine* line_;
  QScrollArea* scroll_;
  QLabel* lines_;
};

}  // namespace torsio::gui
