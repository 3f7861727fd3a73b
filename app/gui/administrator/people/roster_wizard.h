// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include <QWizard>

#include "app/services/people/roster_import.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QRadioButton;

namespace torsio::gui {

class DataTable;
class FieldChecks;
class ShellContext;

/// What the pages of the wizard share.
struct RosterImport {
  RosterKind kind = RosterKind::kTrainees;
  std::optional<RosterFile> file{};
  RosterColumns columns{};
  std::optional<RosterPreview> preview{};
  std::optional<RosterOutcome> outcome{};
};

class RosterPreviewPage;

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
  /// While something runs: stops it, and closes when it has stopped. Nothing is stored then.
  void reject() override;

 private:
  ShellContext& shell_;
  RosterImport import_;
  RosterPreviewPage* preview_;
  bool closing_ = false;
};

/// First step: whose roster, and where it is.
class RosterFilePage : public QWizardPage {
  Q_OBJECT

 public:
  RosterFilePage(RosterImport& import, QWidget* parent);
  void initializePage() override;
  [[nodiscard]] bool isComplete() const override;
  [[nodiscard]] bool validatePage() override;

 private:
  void choose();
  void saveTemplate();
  void sayColumns();

  RosterImport& import_;
  QRadioButton* trainees_;
  QRadioButton* raters_;
  QLineEdit* path_;
  QLabel* columns_;
  QLabel* problem_;
  QLabel* templateProblem_;
  FieldChecks* checks_;
  QString unreadable_;  // what is wrong with the file
};

/// Second step: which column holds what.
class RosterColumnsPage : public QWizardPage {
  Q_OBJECT

 public:
  RosterColumnsPage(RosterImport& import, QWidget* parent);
  ~RosterColumnsPage() override;
  void initializePage() override;
  [[nodiscard]] bool isComplete() const override;
  [[nodiscard]] bool validatePage() override;

 private:
  void addChoice(RosterField field);
  void showSample();
  void showHint();

  RosterImport& import_;
  QGridLayout* form_;
  DataTable* sample_;
  QLabel* hint_;
  std::map<RosterField, QComboBox*> choices_;
  std::unique_ptr<FieldChecks> checks_;
};

/// Third step: what would happen. Compares and tries out away from the window's thread.
class RosterPreviewPage : public QWizardPage {
  Q_OBJECT

 public:
  RosterPreviewPage(RosterImport& import, ShellContext& shell, QWidget* parent);
  void initializePage() override;
  [[nodiscard]] bool isComplete() const override;
  /// The import itself; `done` follows when everything is stored.
  void commit(std::function<void()> done);
  [[nodiscard]] bool busy() const noexcept { return busy_; }

 private:
  void begin(const QString& what);
  void showPreview();
  void showProblem(const QString& words);
  void showProgress(const QString& step, double fraction);

  RosterImport& import_;
  ShellContext& shell_;
  QLabel* summary_;
  QProgressBar* progress_;
  DataTable* lines_;
  bool busy_ = false;
};

}  // namespace torsio::gui
