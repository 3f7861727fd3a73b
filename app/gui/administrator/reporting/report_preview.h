// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextBrowser>

#include "app/report/wording.h"
#include "assessment/report/report_model.h"

namespace torsio::gui {

/// The whole report to scroll through before it is written: the same words, tables and figures, on paper
/// white whatever the theme.
class ReportPreview : public QTextBrowser {
  Q_OBJECT

 public:
  explicit ReportPreview(QWidget* parent = nullptr);

  /// The words are those of `wording`: the language of the report, whatever that of the window.
  void setReport(const ReportModel& model, const Wording& wording);

 Q_SIGNALS:
  /// A number was pressed: its line of the table of numbers, as numberAddress() names it.
  void numberPressed(const QString& address);

 private:
  [[nodiscard]] static QString tableHtml(const ReportTable& table, const Wording& wording);
};

}  // namespace torsio::gui
