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

/// The look of charts in a theme of the window.
[[nodiscard]] ChartStyle chartStyle(const Theme& theme);

/// A figure of a report drawn into a widget, with the same builder as on paper. Ctrl+C copies it as a picture
/// on white and as the table of its values. Says its values in the accessible description. In the language of
/// the window.
class FigureCanvas : public QGraphicsView {
  Q_OBJECT

 public:
  explicit FigureCanvas(QWidget* parent = nullptr);

  void setFigure(const ReportFigure& figure);
  void setTheme(const Theme& theme);
  void copy() const;

  /// As it would be printed, for documents.
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
  QGraphicsWidget* item_ = nullptr;  // the scene's
};

/// Tab-separated with a header line: what a spreadsheet takes.
[[nodiscard]] QString tabbed(const ReportTable& table);

}  // namespace torsio::gui
