// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QFrame>

#include "app/gui/widgets/theme.h"
#include "assessment/results/report_model.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace torsio::gui {

class DataTable;
class FigureCanvas;

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

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fillTable(const ReportTable& table);
  void showNotes(const std::vector<Text>& notes, const Provenance& provenance);
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
