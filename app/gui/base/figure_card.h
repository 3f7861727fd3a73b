// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QFrame>
#include <QGraphicsView>
#include <QImage>

#include "app/gui/widgets/theme.h"
#include "app/outputs/charts/chart_style.h"
#include "assessment/results/report_model.h"

class QGraphicsWidget;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace torsio::gui {

/// Returns the chart style of a window theme.
[[nodiscard]] ChartStyle chartStyle(const Theme& theme);

/// A figure of a report in a widget, built like the printed one. Ctrl+C copies it as a picture on white and
/// as a table of its values. The accessible description contains its values. In the window's language.
class FigureCanvas : public QGraphicsView {
  Q_OBJECT

 public:
  explicit FigureCanvas(QWidget* parent = nullptr);

  void setFigure(const ReportFigure& figure);
  void setTheme(const Theme& theme);
  void copy() const;

  /// Renders the figure as printed, for documents.
  [[nodiscard]] QImage picture(const QSize& size) const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 220}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void rebuild();
  void fit();
  void describe();

  std::optional<ReportFigure> figure_;
  ChartStyle style_;
  QGraphicsWidget* item_ = nullptr;  // owned by the scene
};

/// Returns tab-separated text with a header line, for spreadsheets.
[[nodiscard]] QString tabbed(const ReportTable& table);

class DataTable;

/// A figure with its title, notes and table of values, so that eyes, screen readers and spreadsheets get the
/// same content; or only a table of the report. In the window's language.
class FigureCard : public QFrame {
  Q_OBJECT

 public:
  explicit FigureCard(QWidget* parent = nullptr);

  void setFigure(const ReportFigure& figure);
  /// Shows a table without a figure.
  void setTable(const ReportTable& table);
  void setTheme(const Theme& theme);
  void showTable(bool table);

 private:
  void fillTable(const ReportTable& table);
  void showNotes(const std::vector<ReportParagraph>& notes, const Provenance& provenance);
  void showTexts();
  void copy();
  void retranslate();

  std::optional<ReportFigure> figure_;  // the figure shown; empty: only a table
  std::optional<ReportTable> alone_;
  QLabel* title_;
  QLabel* notes_;
  QPushButton* picture_;
  QPushButton* values_;
  QPushButton* copy_;
  QStackedWidget* stack_;
  FigureCanvas* canvas_;
  DataTable* table_;
};

}  // namespace torsio::gui
