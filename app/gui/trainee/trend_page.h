// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/base/page.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/trend.h"

class QComboBox;
class QLabel;

namespace torsio::gui {

class Card;
class DataTable;
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

}  // namespace torsio::gui
