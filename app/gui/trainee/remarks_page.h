// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/gui/base/page.h"
#include "app/gui/widgets/page_parts.h"
#include "app/services/training/questions.h"
#include "app/services/training/remarks.h"
#include "assessment/domain/ids.h"

class QLabel;
class QListWidget;
class QVBoxLayout;
class QComboBox;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

class Card;
class PageHeading;

/// Physicians' remarks on one's runs, at their moments; replies; one's own marks first, then the gap.
class RemarksPage : public Page {
  Q_OBJECT

 public:
  explicit RemarksPage(ShellContext& shell, QWidget* parent = nullptr);

  void enter(const QVariant& argument) override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;

 private:
  void readAll();
  void fillList();
  void fillRemarks();
  void fillMarks();
  void addRemark(const TraineeRemark& remark, bool reply);
  /// Changes the record and rereads it.
  void change(const std::function<void(SessionContext&)>& action);
  [[nodiscard]] const TrialRemarks* chosen() const;

  std::vector<TrialRemarks> all_;
  const Theme* theme_;
  PageHeading* heading_;
  QListWidget* list_;
  QLabel* empty_;
  QWidget* right_;
  Card* remarks_;
  QVBoxLayout* threads_;
  Card* marks_;
  QVBoxLayout* sheet_;
};

class ShellContext;

/// Below a debrief's trace: sends the moment shown to a chief physician, and shows questions, waiting times
/// and answers. Hidden if nobody can be asked.
class AskCard : public Card {
  Q_OBJECT

 public:
  explicit AskCard(ShellContext& shell, QWidget* parent = nullptr);

  /// Reads the questions allowed about one's own run; empty: no run.
  void setRun(const TrialId& trialId);
  /// Sets the moment to ask about, s.
  void setMoment(double at_s);
  /// Sends the question.
  void ask();
  [[nodiscard]] const QuestionDesk& questions() const noexcept { return desk_; }
  void retranslate();

 Q_SIGNALS:
  /// A question was sent: the run's bookmarks have changed.
  void asked(double at_s);

 private:
  void fill();
  void addQuestion(const OwnQuestion& question);

  ShellContext& shell_;
  TrialId trialId_;
  double at_s_ = 0.0;
  QuestionDesk desk_;
  QLabel* whomLabel_;
  QComboBox* whom_;
  QLineEdit* text_;
  QPushButton* ask_;
  QVBoxLayout* list_;
};

}  // namespace torsio::gui
