// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include <QWizard>

#include "app/session/people/roster_import.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QRadioButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// What the pages of the wizard share.
struct RosterImport {
  RosterKind kind = RosterKind::kTrainees;
  std::optional<RosterFile> file{};
  RosterColumns columns{};
  std::optional<RosterPreview> preview{};
  std::optional<RosterOutcome> outcome{};
};

/// From a file to people, in three steps: the file, which column is what, and what would happen line by line.
/// Nothing is stored before the last button, and then all or nothing.
class RosterWizard : public QWizard {
  Q_OBJECT

 public:
  explicit RosterWizard(ShellContext& shell, QWidget* parent = nullptr);

  /// What was done; empty while nothing was.
  [[nodiscard]] const std::optional<RosterOutcome>& outcome() const noexcept { return import_.outcome; }

 protected:
  void accept() override;

 private:
  ShellContext& shell_;
  RosterImport import_;
};

/// First step: whose roster, and where it is.
class RosterFilePage : public QWizardPage {
  Q_OBJECT

 public:
  RosterFilePage(RosterImport& import, QWidget* parent);
  [[nodiscard]] bool isComplete() const override;
  [[nodiscard]] bool validatePage() override;

 private:
  void choose();
  void saveTemplate();

  RosterImport& import_;
  QRadioButton* trainees_;
  QRadioButton* raters_;
  QLineEdit* path_;
  QLabel* problem_;
};

/// Second step: which column holds what.
class RosterColumnsPage : public QWizardPage {
  Q_OBJECT

 public:
  RosterColumnsPage(RosterImport& import, QWidget* parent);
  void initializePage() override;
  [[nodiscard]] bool isComplete() const override;
  [[nodiscard]] bool validatePage() override;

 private:
  void showSample();

  RosterImport& import_;
  QFormLayout* form_;
  DataTable* sample_;
  std::map<RosterField, QComboBox*> choices_;
};

/// Third step: what would happen.
class RosterPreviewPage : public QWizardPage {
  Q_OBJECT

 public:
  RosterPreviewPage(RosterImport& import, ShellContext& shell, QWidget* parent);
  void initializePage() override;
  [[nodiscard]] bool isComplete() const override;

 private:
  RosterImport& import_;
  ShellContext& shell_;
  QLabel* summary_;
  DataTable* lines_;
};

}  // namespace torsio::gui
