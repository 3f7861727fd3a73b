// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextBrowser>

#include "assessment/report/report_model.h"

namespace torsio::gui {

/// The whole report to scroll through before it is written: the same words, tables and figures, on paper
/// white whatever the theme.
class ReportPreview : public QTextBrowser {
  Q_OBJECT

 public:
  explicit ReportPreview(QWidget* parent = nullptr);

  void setReport(const ReportModel& model);

 private:
  [[nodiscard]] QString tableHtml(const ReportTable& table) const;
};

}  // namespace torsio::gui
