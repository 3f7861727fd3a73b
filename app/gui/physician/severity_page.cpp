// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/severity_page.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"

namespace torsio::gui {

namespace {

constexpr double kDot = 5.0;
constexpr double kAsThePanel_points = 0.25;

QString oneDecimal(double points) {
  return QLocale().toString(points, 'f', 1);
}

}  // namespace

SeverityPlot::SeverityPlot(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void SeverityPlot::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void SeverityPlot::setSeverity(const OwnSeverity& severity) {
  severity_ = severity;
  retranslate();
  update();
}

void SeverityPlot::retranslate() {
  setAccessibleName(tr("Your marks against the panel's"));
  setAccessibleDescription(
      tr("Cases: %1; the list beside it holds the same figures").arg(severity_.cases.size()));
  update();
}

void SeverityPlot::drawAxes(QPainter& painter, const QRectF& area) const {
  const double lo = severity_.lowest_points;
  const double hi = severity_.highest_points;
  painter.setPen(theme_->line);
  painter.setBrush(theme_->window);
  painter.drawRect(area);
  const int line = fontMetrics().height();
  for (double points = std::ceil(lo); points <= hi; points += hi - lo > 6.0 ? 2.0 : 1.0) {
    const double share = (points - lo) / (hi - lo);
    const double x = area.left() + share * area.width();
    const double y = area.bottom() - share * area.height();
    painter.setPen(theme_->line);
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(theme_->quietText);
    painter.drawText(QRectF(x - 20, area.bottom() + 2, 40, line), Qt::AlignCenter, pointsText(points));
    painter.drawText(QRectF(area.left() - 34, y - line / 2.0, 28, line), Qt::AlignRight | Qt::AlignVCenter,
                     pointsText(points));
  }
  painter.setPen(QPen(theme_->border, 1.5, Qt::DashLine));
  painter.drawLine(area.bottomLeft(), area.topRight());
  painter.setPen(theme_->quietText);
  painter.drawText(QRectF(area.left(), area.bottom() + line + 2, area.width(), line), Qt::AlignCenter,
                   tr("mean of the others, points"));
  painter.drawText(area.adjusted(kSpace, kSpace, -kSpace, -kSpace), Qt::AlignLeft | Qt::AlignTop,
                   tr("you are more lenient"));
  painter.drawText(area.adjusted(kSpace, kSpace, -kSpace, -kSpace), Qt::AlignRight | Qt::AlignBottom,
                   tr("you are stricter"));
}

void SeverityPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int line = fontMetrics().height();
  const double side = std::min<double>(width() - 48.0, height() - 2.0 * line - 16.0);
  const double left = std::max(40.0, (width() - side) / 2.0);
  const QRectF area(left, 8.0, std::max(side, 10.0), std::max(side, 10.0));
  drawAxes(painter, area);
  const double span = severity_.highest_points - severity_.lowest_points;
  painter.setPen(QPen(theme_->surface, 1.0));
  painter.setBrush(theme_->accent);
  for (const SeverityCase& one : severity_.cases) {
    painter.drawEllipse(QPointF(area.left() + (one.panel - severity_.lowest_points) / span * area.width(),
                                area.bottom() - (one.own - severity_.lowest_points) / span * area.height()),
                        kDot, kDot);
  }
}

SeverityPage::SeverityPage(ShellContext& shell, QWidget* parent)
    : Page(shell, parent),
      heading_(new PageHeading(this)),
      figureCard_(new Card(QString(), this)),
      figure_(new QLabel(this)),
      reading_(sentence(this, false)),
      interval_(sentence(this)),
      thanks_(sentence(this)),
      plotCard_(new Card(QString(), this)),
      plot_(new SeverityPlot(this)),
      table_(new DataTable(QStringLiteral("review.severity"), this)) {
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 2 * kSpace, 3 * kSpace, 2 * kSpace}, 2 * kSpace);
  column->addWidget(heading_);
  QHBoxLayout* row = rowOf({}, 2 * kSpace);
  auto* left = new QVBoxLayout;
  left->setSpacing(2 * kSpace);
  figure_->setProperty("figure", true);
  for (QLabel* label : {figure_, reading_, interval_, thanks_}) {
    figureCard_->content()->addWidget(label);
  }
  left->addWidget(figureCard_);
  plotCard_->content()->addWidget(plot_, 1);
  left->addWidget(plotCard_, 1);
  row->addLayout(left, 3);
  row->addWidget(table_, 2);
  column->addLayout(row, 1);
}

void SeverityPage::enter(const QVariant&) {
  severity_ = ownSeverity(shell().session());
  showSeverity();
}

void SeverityPage::showSeverity() {
  plot_->setSeverity(severity_);
  plotCard_->setVisible(!severity_.cases.empty());
  const auto count = static_cast<int>(severity_.cases.size());
  if (severity_.difference_points) {
    const double off = *severity_.difference_points;
    figure_->setText(signedText(off));
    reading_->setText(std::abs(off) < kAsThePanel_points
                          ? tr("points from the panel: you judge as the others do.")
                      : off < 0.0 ? tr("points from the panel: you are stricter.")
                                  : tr("points from the panel: you are more lenient."));
    interval_->setText(severity_.interval_points
                           ? tr("95 % interval %1 to %2; cases: %3. Your mean is %4, the others' %5.")
                                 .arg(signedText(severity_.interval_points->lower),
                                      signedText(severity_.interval_points->upper), QLocale().toString(count),
                                      oneDecimal(*severity_.ownMean_points),
                                      oneDecimal(*severity_.panelMean_points))
                           : tr("From one case; an interval needs two at least."));
  } else {
    figure_->setText(QStringLiteral("\u2013"));
    reading_->setText(tr("Nothing to compare yet."));
    interval_->setText(tr("Cases appear here once all physicians have submitted them."));
  }
  thanks_->setText(
      severity_.waiting > 0
          ? tr("Your cases that wait for the others: %1. Thank you for your time.").arg(severity_.waiting)
      : severity_.sealed > 0
          ? tr("Cases whose panel waits until you have submitted all your own sheets of the occasion: %1.")
                .arg(severity_.sealed)
          : tr("Thank you for your time. Reports never correct your marks silently."));
  std::vector<Row> rows;
  for (const SeverityCase& one : severity_.cases) {
    rows.push_back({toQString(one.label),
                    {{tr("Case %1").arg(toQString(one.label)), static_cast<int>(rows.size())},
                     {oneDecimal(one.own), one.own},
                     {oneDecimal(one.panel), one.panel},
                     {signedText(one.own - one.panel), one.own - one.panel}}});
  }
  table_->setRows(std::move(rows));
}

void SeverityPage::retranslate() {
  heading_->setTexts(tr("My severity"),
                     tr("For your eyes only. Overall marks of cases that everyone has submitted; the mean of "
                        "the others does not contain yours."));
  figureCard_->setTitle(tr("You and the panel"));
  plotCard_->setTitle(tr("Your mark (upwards) against the panel's mean"));
  table_->view().setAccessibleName(tr("Your marks and the panel's, case by case"));
  table_->setColumns({{tr("Case")}, {tr("You"), true}, {tr("Panel"), true}, {tr("Difference"), true}});
  table_->setEmptyText(tr("No case is complete yet."));
  plot_->retranslate();
  showSeverity();
}

void SeverityPage::applyTheme(const Theme& theme) {
  plot_->setTheme(theme);
}

}  // namespace torsio::gui
