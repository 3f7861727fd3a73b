// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/gui/base/page.h"
#include "app/gui/widgets/theme.h"
#include "app/services/review/discrepancy_review.h"

class QLabel;

namespace torsio::gui {

class Card;
class DataTable;
class PageHeading;

/// One's own marks against the panel's means, one dot per case: milder above the diagonal, stricter below.
class SeverityPlot : public QWidget {
  Q_OBJECT

 public:
  explicit SeverityPlot(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void setSeverity(const OwnSeverity& severity);
  void retranslate();
  [[nodiscard]] QSize sizeHint() const override { return {380, 320}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 220}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawAxes(QPainter& painter, const QRectF& area) const;
  const Theme* theme_;
  OwnSeverity severity_;
};

/// A physician's own severity, visible only to them: there is no ranking anywhere.
class SeverityPage : public Page {
  Q_OBJECT

 public:
  explicit SeverityPage(ShellContext& shell, QWidget* parent = nullptr);

  void enter(const QVariant& argument) override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;

 private:
  void showSeverity();

  PageHeading* heading_;
  Card* figureCard_;
  QLabel* figure_;
  QLabel* reading_;
  QLabel* interval_;
  QLabel* thanks_;
  Card* plotCard_;
  SeverityPlot* plot_;
  DataTable* table_;
  OwnSeverity severity_;
};

}  // namespace torsio::gui
