// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include <QString>
#include <QWizard>

#include "app/services/people/roster_import.h"
#include "sim/core/error.h"

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

/// State shared by the pages of the wizard.
struct RosterImport {
  RosterKind kind = RosterKind::kTrainees;
  std::optional<RosterFile> file{};
  RosterColumns columns{};
  std::optional<RosterPreview> preview{};
  std::optional<RosterOutcome> outcome{};
};

class RosterPreviewPage;

/// Imports people from a file in three steps: file, columns, preview line by line. Nothing is stored before
/// the last button, and then all or nothing.
class RosterWizard : public QWizard {
  Q_OBJECT

 public:
  explicit RosterWizard(ShellContext& shell, QWidget* parent = nullptr);

  /// Returns the result of the import; empty if nothing was imported.
  [[nodiscard]] const std::optional<RosterOutcome>& outcome() const noexcept { return import_.outcome; }

 protected:
  void accept() override;
  /// Stops running work and then closes. Nothing is stored.
  void reject() override;

 private:
  ShellContext& shell_;
  RosterImport import_;
  RosterPreviewPage* preview_;
  bool closing_ = false;
};

/// First step: kind of roster and file.
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
  QString unreadable_;  // error of the file
};

/// Second step: assigns columns.
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

/// Third step: preview. Compares and validates in the background.
class RosterPreviewPage : public QWizardPage {
  Q_OBJECT

 public:
  RosterPreviewPage(RosterImport& import, ShellContext& shell, QWidget* parent);
  void initializePage() override;
  [[nodiscard]] bool isComplete() const override;
  /// Imports; calls `done` when everything is stored.
  void commit(std::function<void()> done);
  [[nodiscard]] bool busy() const noexcept { return busy_; }

 private:
  void begin(const QString& what);
  void showPreview();
  void showProblem(const QString& words);
  void showProgress(const QString& step, double fraction);
  void showNote(const QString& line);

  RosterImport& import_;
  ShellContext& shell_;
  QLabel* summary_;
  QProgressBar* progress_;
  DataTable* lines_;
  QLabel* note_;  // of the current line, in full
  bool busy_ = false;
};

/// Keeps at least this height for a widget that comes and goes, so that what is below does not move.
void keepPlace(QWidget* widget, int height_px);
/// Names a field of a roster in the user's language.
[[nodiscard]] QString rosterFieldName(RosterField field);
/// Names the effect on a line, with its sign: "+ new".
[[nodiscard]] QString rosterStatusName(RosterStatus status);
/// Returns the note for a line: its error, changes or peculiarities.
[[nodiscard]] QString rosterNote(const RosterRow& row);
/// Returns error and remedy in sentences.
[[nodiscard]] QString rosterProblem(const Error& error);

}  // namespace torsio::gui
