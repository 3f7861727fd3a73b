// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "app/gui/widgets/card.h"
#include "app/services/training/questions.h"
#include "assessment/domain/ids.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace torsio::gui {

class ShellContext;

/// Under the trace of a debrief: sends the moment that is shown to a chief physician, and shows what was
/// asked, how long it has waited, and the answers. Hidden where nobody may be asked.
class AskCard : public Card {
  Q_OBJECT

 public:
  explicit AskCard(ShellContext& shell, QWidget* parent = nullptr);

  /// Reads what may be asked about this own run; empty: none.
  void setRun(const TrialId& trialId);
  /// The moment that would be asked about, seconds.
  void setMoment(double at_s);
  /// Sends it.
  void ask();
  [[nodiscard]] const QuestionDesk& questions() const noexcept { return desk_; }
  void retranslate();

 Q_SIGNALS:
  /// Was sent: the bookmarks of the run are other ones.
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
