// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/widgets/page_parts.h"
#include "assessment/domain/people/retention.h"

class QLabel;
class QPushButton;

namespace torsio::gui {

class ShellContext;

/// Requests of a trainee about their own record, and the answers.
class OwnRecordCard : public Card {
  Q_OBJECT

 public:
  explicit OwnRecordCard(ShellContext& shell, QWidget* parent = nullptr);

  void read();
  void retranslate();

 private:
  void ask(PersonRequestKind kind);
  void takeBack();
  void showState();
  [[nodiscard]] const PersonRequest* waiting(PersonRequestKind kind) const;

  ShellContext& shell_;
  std::vector<PersonRequest> own_;
  QLabel* words_;
  QLabel* state_;
  QPushButton* copy_;
  QPushButton* erase_;
  QPushButton* takeBack_;
};

}  // namespace torsio::gui
