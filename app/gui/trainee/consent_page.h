// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/base/page.h"
#include "app/gui/widgets/page_parts.h"
#include "assessment/domain/people/consent.h"
#include "assessment/domain/people/retention.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace torsio::gui {

class Card;
class OwnRecordCard;
class PageHeading;

/// Shows all consent texts of the centre and asks for the trainee's decision about each before anything is
/// recorded. The training record is required to begin; the others are optional.
class ConsentPage : public Page {
  Q_OBJECT

 public:
  explicit ConsentPage(ShellContext& shell, QWidget* parent = nullptr);

  /// `argument`: the page to open after the decision; default: the first one.
  void enter(const QVariant& argument) override;
  void retranslate() override;

 private:
  /// A purpose other than the training record.
  struct Choice {
    std::string purpose;
    QCheckBox* agreed;
  };

  void decide(bool granted);
  void decideOne(const std::string& purpose, bool granted);
  void readTexts();
  void showOthers(const ConsentWords& words);
  void showState();

  ConsentVersion asked_;
  std::vector<ConsentDecision> own_;
  std::vector<Choice> others_;
  PageId then_ = PageId::kNextStep;
  PageHeading* heading_;
  Card* card_;
  QLabel* text_;
  Card* othersCard_;
  QLabel* othersText_;
  QVBoxLayout* othersColumn_;
  QLabel* state_;
  QCheckBox* understood_;
  OwnRecordCard* ownRecord_;
  QPushButton* agree_;
  QPushButton* decline_;
};

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
