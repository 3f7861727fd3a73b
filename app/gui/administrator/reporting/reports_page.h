// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/gui/base/page.h"
#include "app/outputs/report/report_export.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace torsio::gui {

class ExportDialog;
class PageHeading;
class ReportPreview;

/// From a cohort to a report that may leave the house: choose, freeze, look, write. What left, and in which
/// form, is kept in the audit trail.
class ReportsPage : public Page {
  Q_OBJECT

 public:
  explicit ReportsPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

  /// Freezes the data of the chosen cohort and evaluation under a name, and chooses the set.
  bool freeze(const std::string& name);
  /// Writes the file. False: it was given up or went wrong, which has been said.
  bool exportTo(ReportFormat format, const std::filesystem::path& file, const CsvStyle& look = {});
  /// Writes recordings and single marks of the chosen cohort under their codes into a new folder, as far as
  /// the user may see them. False: it went wrong, which has been said.
  bool exportTables(const std::filesystem::path& folder);

  /// Waits until the report is prepared: pictures and tests.
  void settle();
  /// Puts the dialog of exports on the page, for pictures.
  ExportDialog& placeExport();

  [[nodiscard]] const std::shared_ptr<CohortInputs>& inputs() const noexcept { return inputs_; }

 private:
  void fillFrozen();
  void compute();
  void showReport();
  void askFreeze();
  void askExport(ReportFormat format);
  void askTables();
  void askOther();
  /// Opens what a number comes from; empty: to choose one there.
  void askOrigin(const QString& address);
  void showButtons();
  [[nodiscard]] ReportRequest request() const;
  /// Chosen, or that of the window.
  [[nodiscard]] std::string reportLanguage() const;

  std::shared_ptr<TrialDigests> digests_;
  std::shared_ptr<CohortInputs> inputs_;  // of what is shown; empty while it is computed
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
