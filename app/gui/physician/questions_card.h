// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "app/gui/widgets/page_parts.h"
#include "app/services/training/questions.h"
#include "assessment/domain/ids.h"

class QPushButton;
class QVBoxLayout;

namespace torsio::gui {

class ShellContext;

/// Questions of trainees about moments of practice runs, with names, in a physician's queue, longest waiting
/// first; and a week's answers, which can be edited. Hidden if there are neither.
class QuestionsCard : public Card {
  Q_OBJECT

 public:
  explicit QuestionsCard(ShellContext& shell, QWidget* parent = nullptr);

  /// Rereads the questions; the caller handles exceptions.
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
  std::vector<PhysicianQuestion> questions_;  ///< unanswered
  std::vector<PhysicianQuestion> answered_;   ///< recent ones, last answer first
  QVBoxLayout* list_;
};

/// Trainees' unread replies to one's remarks, in a physician's queue. Hidden if there are none.
class RepliesCard : public Card {
  Q_OBJECT

 public:
  explicit RepliesCard(ShellContext& shell, QWidget* parent = nullptr);

  /// Rereads the replies; the caller handles exceptions.
  void read();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  ShellContext& shell_;
  QVBoxLayout* list_;
};

}  // namespace torsio::gui
