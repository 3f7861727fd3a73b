// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "app/gui/widgets/card.h"
#include "app/services/training/questions.h"
#include "assessment/domain/ids.h"

class QPushButton;
class QVBoxLayout;

namespace torsio::gui {

class ShellContext;

/// In a physician's queue: moments of practice runs that trainees ask about by name, the longest waiting
/// first, and the last answers of a week, which can be edited. Hidden while there is neither.
class QuestionsCard : public Card {
  Q_OBJECT

 public:
  explicit QuestionsCard(ShellContext& shell, QWidget* parent = nullptr);

  /// Reads them anew; the caller's catch reports.
  void read();
  [[nodiscard]] const std::vector<PhysicianQuestion>& questions() const noexcept { return questions_; }
  /// Shows the moment with a field for the answer.
  void open(const RemarkId& questionId);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fill();
  void addAnswer(const PhysicianQuestion& question);
  void show(const PhysicianQuestion& question, const Debrief& run);

  ShellContext& shell_;
  std::vector<PhysicianQuestion> questions_;  ///< what waits
  std::vector<PhysicianQuestion> answered_;   ///< lately, the last answer first
  QVBoxLayout* list_;
};

}  // namespace torsio::gui
