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

/// Consent texts: all versions with purposes and languages; the newest can be edited, published as the next
/// version, and printed as forms to sign.
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
  /// Shows an error at each incomplete field. True: complete.
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
  ConsentVersion shown_;  // the newest version with its edits, or an earlier one
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
