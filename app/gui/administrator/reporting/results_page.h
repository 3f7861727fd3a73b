// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "app/gui/base/page.h"
#include "app/outputs/report/report_data.h"
#include "assessment/results/report_model.h"

class QComboBox;
class QLabel;
class QListWidget;

namespace torsio::gui {

class FigureCard;
class PageHeading;

/// All figures and tables of the cohort report with their values: a preview of the report.
class ResultsPage : public Page {
  Q_OBJECT

 public:
  explicit ResultsPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;

  /// Shows the figure or table with this id of the report ("figure-22").
  void showItem(const QString& id);
  /// Waits until the chosen item is computed (for screenshots and tests).
  void settle();

 private:
  void compute();
  void fill();
  void showCurrent();

  std::shared_ptr<TrialDigests> digests_;
  std::shared_ptr<ReportModel> model_;
  PageHeading* heading_;
  QLabel* cohortLabel_ = nullptr;
  QComboBox* cohort_;
  QLabel* campaignLabel_ = nullptr;
  QComboBox* campaign_;
  QListWidget* contents_;
  QLabel* empty_;
  FigureCard* card_;
};

}  // namespace torsio::gui
