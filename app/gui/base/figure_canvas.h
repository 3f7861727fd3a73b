// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QGraphicsView>
#include <QImage>

#include "app/gui/widgets/theme.h"
#include "app/outputs/charts/chart_style.h"
#include "assessment/results/report_model.h"

class QGraphicsWidget;

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

}  // namespace torsio::gui
