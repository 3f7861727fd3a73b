// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "app/gui/base/page.h"
#include "app/outputs/report/report_export.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace torsio::gui {

class ExportDialog;
class PageHeading;
class ReportPreview;

/// Creates a report of a cohort to publish: choose, freeze, preview, write. Exports and their format are
/// recorded in the audit trail.
class ReportsPage : public Page {
  Q_OBJECT

 public:
  explicit ReportsPage(ShellContext& shell);

  /// `argument`: the cohort to show; may be empty.
  void enter(const QVariant& argument) override;
  void retranslate() override;

  /// Freezes the data of the chosen cohort and evaluation as a named set, and selects it.
  bool freeze(const std::string& name, const std::string& whyIncomplete = {});
  /// Writes the file. False: cancelled or failed; the user has been told.
  bool exportTo(ReportFormat format, const std::filesystem::path& file, const CsvStyle& look = {});
  /// Writes recordings and individual marks of the chosen cohort with codes into a new folder, as far as the
  /// user may see them. False: failed; the user has been told.
  bool exportTables(const std::filesystem::path& folder);

  /// Waits until the report is ready (for screenshots and tests).
  void settle();
  /// Shows the export dialog on the page (for screenshots).
  ExportDialog& placeExport();

  [[nodiscard]] const std::shared_ptr<CohortInputs>& inputs() const noexcept { return inputs_; }

 private:
  void fillFrozen();
  void compute();
  void showReport();
  void askFreeze();
  /// Asks why a state with missing sheets is frozen; "" if none is missing, empty if nothing was said.
  std::optional<std::string> askWhyIncomplete();
  void askExport(ReportFormat format);
  void askTables();
  void askOther();
  /// Opens the origin of a number; empty: the user chooses one there.
  void askOrigin(const QString& address);
  void showButtons();
  [[nodiscard]] ReportRequest request() const;
  /// Returns the chosen language, or the window's.
  [[nodiscard]] std::string reportLanguage() const;

  std::shared_ptr<TrialDigests> digests_;
  std::shared_ptr<CohortInputs> inputs_;  // for the report shown; empty while being computed
  std::shared_ptr<ReportModel> model_;
  std::string shownLanguage_;
  PageHeading* heading_;
  QPushButton* pdf_;
  QPushButton* csv_;
  QPushButton* tables_;
  QPushButton* other_;
  QPushButton* origin_;
  QLabel* cohortLabel_;
  QComboBox* cohort_;
  QLabel* campaignLabel_;
  QComboBox* campaign_;
  QLabel* frozenLabel_;
  QComboBox* frozen_;
  QPushButton* freeze_;
  QLabel* identityLabel_;
  QComboBox* identity_;
  QLabel* languageLabel_;
  QComboBox* language_;
  QLabel* warning_;
  ReportPreview* preview_;
};

}  // namespace torsio::gui
