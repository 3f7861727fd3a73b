// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <set>

#include <QDialog>
#include <QImage>
#include <QString>
#include <QTextBrowser>

#include "app/outputs/report/cell_trace.h"
#include "app/outputs/wording/wording.h"
#include "assessment/results/report_model.h"

class QTreeWidget;

namespace torsio::gui {

/// Preview of the whole report with the same texts, tables and figures as the file, on white in every theme.
/// Long tables show their first rows, and all on request.
class ReportPreview : public QTextBrowser {
  Q_OBJECT

 public:
  explicit ReportPreview(QWidget* parent = nullptr);

  /// `wording`: the language of the report, independent of the window's.
  void setReport(const ReportModel& model, const Wording& wording);

 Q_SIGNALS:
  /// A number was clicked: its address in the table of numbers, as given by keyAddress().
  void numberPressed(const QString& address);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  [[nodiscard]] QMimeData* createMimeDataFromSelection() const override;

 private:
  void showReport();
  void keepLinesShort();
  void showBarIfNeeded();
  /// Shows all rows of a long table, or only the first ones again.
  void toggleRows(const QString& name);
  [[nodiscard]] QString tableHtml(const ReportTable& table, const QString& name,
                                  const Wording& wording) const;

  ReportModel model_;
  Wording wording_;
  std::map<QString, QImage> pictures_;
  int besideText_ = 0;       // margin beside the text, px, if the page is wider than a line should be
  std::set<QString> whole_;  // tables shown in full, by number
};

class DataTable;
class ShellContext;

/// All numbers of a report; traces the chosen one step by step to marks, criteria, recording and program
/// version. GUI thread.
class TraceDialog : public QDialog {
  Q_OBJECT

 public:
  /// `inputs`: the report's data.
  TraceDialog(ShellContext& shell, const CohortId& cohortId, std::shared_ptr<const CohortInputs> inputs,
              QWidget* parent);

  /// Selects the number with this address and traces it.
  void follow(const QString& address);

 private:
  void fill();
  void start();
  void show(const TraceStep& step);

  ShellContext& shell_;
  CohortId cohortId_;
  std::shared_ptr<const CohortInputs> inputs_;
  QString wanted_;
  QString followed_;
  bool running_ = false;
  DataTable* numbers_;
  QTreeWidget* steps_;
};

}  // namespace torsio::gui
