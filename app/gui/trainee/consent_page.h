// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/gui/base/page.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace torsio::gui {

class Card;
class PageHeading;

/// Shows the text about the training record and takes the trainee's own decision before anything is recorded.
class ConsentPage : public Page {
  Q_OBJECT

 public:
  explicit ConsentPage(ShellContext& shell, QWidget* parent = nullptr);

  /// `argument`: the page to go to after the decision; the first one without.
  void enter(const QVariant& argument) override;
  void retranslate() override;

 private:
  void decide(bool granted);
  void readText();

  std::string version_;
  PageId then_ = PageId::kNextStep;
  PageHeading* heading_;
  Card* card_;
  QLabel* text_;
  QLabel* state_;
  QCheckBox* understood_;
  QPushButton* agree_;
  QPushButton* decline_;
};

}  // namespace torsio::gui
