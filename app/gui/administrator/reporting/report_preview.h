// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>

#include <QImage>
#include <QString>
#include <QTextBrowser>

#include "app/outputs/wording/wording.h"
#include "assessment/results/report_model.h"

namespace torsio::gui {

/// The whole report to scroll through before it is written: the same words, tables and figures, on paper
/// white whatever the theme. Of a long table the first rows are shown, and all on request.
class ReportPreview : public QTextBrowser {
  Q_OBJECT

 public:
  explicit ReportPreview(QWidget* parent = nullptr);

  /// The words are those of `wording`: the language of the report, whatever that of the window.
  void setReport(const ReportModel& model, const Wording& wording);

 Q_SIGNALS:
  /// A number was pressed: its line of the table of numbers, as keyAddress() names it.
  void numberPressed(const QString& address);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  [[nodiscard]] QMimeData* createMimeDataFromSelection() const override;

 private:
  void showReport();
  void keepLinesShort();
  void showBarIfNeeded();
  /// Shows all rows of a long table, or the first ones again.
  void toggleRows(const QString& name);
  [[nodiscard]] QString tableHtml(const ReportTable& table, const QString& name,
                                  const Wording& wording) const;

  ReportModel model_;
  Wording wording_;
  std::map<QString, QImage> pictures_;
  int besideText_ = 0;       // free of text, px, where the page is wider than a line should be
  std::set<QString> whole_;  // tables of which all rows are shown, by their number
};

}  // namespace torsio::gui
