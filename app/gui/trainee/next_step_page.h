// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/base/page.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/run_session.h"
#include "assessment/domain/ids.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace torsio::gui {

class StationDesk;

class Card;
class PageHeading;

/// A trainee's home page: the next step, open modules, locked modules and why.
class NextStepPage : public Page {
  Q_OBJECT

 public:
  /// `desk` must outlive the page.
  NextStepPage(ShellContext& shell, StationDesk& desk, QWidget* parent = nullptr);

  void enter(const QVariant& argument) override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;

 private:
  StationDesk& desk_;

  void fill();
  /// Returns the button for Enter: a visitor's first twist, or the next step; null if there is none.
  [[nodiscard]] QPushButton* startButton() const;
  void focusStart();
  void fillNext();
  void fillSession();
  void fillNotices();
  void addModule(const ModuleStep& step);
  void begin(const ModuleId& moduleId, bool graded, bool guided = false);
  /// Returns whether a visitor uses a simulated trainee's desk, and so has not done what that trainee's
  /// record says.
  [[nodiscard]] bool forVisitor() const;
  void fillVisitor();

  NextSteps steps_;
  std::vector<RecoveredTrial> recovered_;
  const Theme* theme_;
  PageHeading* heading_;
  QPushButton* consent_;
  QVBoxLayout* notices_;
  Card* visitor_;
  QLabel* visitorWords_;
  QPushButton* tryTwist_;
  Card* next_;
  QVBoxLayout* nextContent_;
  Card* session_;
  QLabel* bestPicture_;
  QLabel* sessionWords_;
  QPushButton* lookAtBest_;
  QLabel* listTitle_;
  QVBoxLayout* modules_;
};

}  // namespace torsio::gui
