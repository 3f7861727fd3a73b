// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "app/gui/base/page.h"
#include "app/gui/widgets/theme.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/trend.h"

class QComboBox;
class QLabel;

namespace torsio::gui {

class Card;
class DataTable;
class FoldedText;
class PageHeading;
class TrendPlot;

/// Progress at one module: attempts, learning curve, distance to the threshold, level.
class TrendPage : public Page {
  Q_OBJECT

 public:
  explicit TrendPage(ShellContext& shell, QWidget* parent = nullptr);

  /// `argument`: id of the module; default: the last one practised.
  void enter(const QVariant& argument) override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;
  /// Selects one of the listed quantities.
  void chooseQuantity(Quantity quantity);
  [[nodiscard]] const Trend& trend() const noexcept { return trend_; }

 private:
  void readTrend();
  void fill();
  void fillChoices();

  NextSteps steps_;
  Trend trend_;
  std::string module_;
  bool filling_ = false;
  PageHeading* heading_;
  QLabel* moduleLabel_;
  QComboBox* modules_;
  QLabel* metricLabel_;
  QComboBox* metrics_;
  Card* level_;
  QLabel* levelName_;
  QLabel* competence_ = nullptr;
  FoldedText* rates_ = nullptr;
  QLabel* levelMeaning_;
  Card* distance_;
  QLabel* distanceFigure_;
  QLabel* distanceText_;
  Card* left_;
  QLabel* leftFigure_;
  QLabel* leftText_;
  Card* chart_;
  TrendPlot* plot_;
  QLabel* note_;
  DataTable* table_;
};

/// Attempts over time with threshold, learning curve and its band; passed and failed differ in shape. Below
/// them, the evidence for the level. The accessible description says the same.
class TrendPlot : public QWidget {
  Q_OBJECT

 public:
  explicit TrendPlot(QWidget* parent = nullptr);

  void setTrend(const Trend& trend);
  void setTheme(const Theme& theme);
  void retranslate();
  /// Returns the values of the grid lines, ascending, in the displayed unit: only whole ones for counts and
  /// yes-or-no answers.
  [[nodiscard]] std::vector<double> marks() const;
  [[nodiscard]] QSize sizeHint() const override { return {640, 340}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Returns a stored value in the displayed unit.
  [[nodiscard]] double shown(double value) const;
  [[nodiscard]] double xOf(double attempt) const;
  [[nodiscard]] double yOf(double value) const;
  void findRange();
  void drawGrid(QPainter& painter) const;
  void drawCurve(QPainter& painter) const;
  void drawPoints(QPainter& painter) const;

  const Theme* theme_;
  Trend trend_;
  double low_ = 0.0;
  double high_ = 1.0;
};

}  // namespace torsio::gui
