// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QDialog>

#include "assessment/domain/people/consent.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;

namespace torsio::gui {

class ShellContext;

/// What people are asked to agree to: every version with its purposes and languages; the newest can be edited
/// and published as the next version, and printed as forms to sign.
class ConsentTextsDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ConsentTextsDialog(ShellContext& shell, QWidget* parent = nullptr);

  void reject() override;

 private:
  void build();
  void read();
  void showVersion();
  void showLanguages();
  void showPurposes();
  void showText();
  void showButtons();
  /// Says at each field what is missing. True: nothing is.
  bool showHints();
  void takeText();
  void addPurpose();
  void removePurpose();
  void addLanguage();
  void publish();
  void print();
  [[nodiscard]] bool newest() const;
  [[nodiscard]] bool edited() const;
  [[nodiscard]] ConsentWords* words();

  ShellContext& shell_;
  std::vector<ConsentVersion> versions_;
  ConsentVersion shown_;  // the newest one as it is edited, or an earlier one
  bool filling_ = false;
  QComboBox* version_;
  QComboBox* language_;
  QPushButton* addLanguage_;
  QListWidget* purposes_;
  QPushButton* addPurpose_;
  QPushButton* removePurpose_;
  QLineEdit* title_;
  QLabel* titleHint_ = nullptr;
  QLabel* textHint_ = nullptr;
  QLabel* languageHint_ = nullptr;
  QPlainTextEdit* text_;
  QPushButton* print_;
  QPushButton* publish_;
};

}  // namespace torsio::gui
