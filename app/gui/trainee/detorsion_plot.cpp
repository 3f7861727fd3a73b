// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/detorsion_plot.h"

#include <algorithm>
#include <cmath>

#include <QLocale>
#include <QPainter>

#include "app/gui/simulator/detorsion_panel.h"
#include "sim/base/angle.h"

namespace torsio::gui {

namespace {

constexpr int kLanes = 3;
constexpr double kLaneLeft = 52.0;
constexpr double kLaneRight = 16.0;
constexpr double kEventsAbove = 22.0;
constexpr double kNameAbove = 18.0;
constexpr double kTimeBelow = 40.0;
constexpr double kLegendBelow = 20.0;
constexpr double kSignRoom = 13.0;
constexpr int kTimeMarks = 6;

}  // namespace

DetorsionPlot::DetorsionPlot(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  retranslate();
}

void DetorsionPlot::setStory(const DetorsionStory& story) {
  story_ = story;
  retranslate();
}

void DetorsionPlot::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void DetorsionPlot::retranslate() {
  setAccessibleName(tr("Angle, blood flow and dose over the time of the tissue"));
  if (!story_.time_s.empty()) {
    const QLocale locale;
    setAccessibleDescription(
        tr("Angle from %1 to %2, blood flow from %3 to %4 %, dose from %5 to %6, in %7 of the tissue.")
            .arg(DetorsionPanel::angleText(story_.angle_rad.front()),
                 DetorsionPanel::angleText(story_.angle_rad.back()),
                 locale.toString(100.0 * story_.flow.front(), 'f', 0),
                 locale.toString(100.0 * story_.flow.back(), 'f', 0),
                 locale.toString(story_.dose.front(), 'f', 2), locale.toString(story_.dose.back(), 'f', 2),
                 DetorsionPanel::clockText(story_.time_s.back() * story_.timeScale)));
  }
  update();
}

QString DetorsionPlot::momentName(DetorsionMoment moment) {
  switch (moment) {
    case DetorsionMoment::kGrip:
      return tr("grip");
    case DetorsionMoment::kLetGo:
      return tr("let go");
    case DetorsionMoment::kClipOn:
      return tr("clip on");
    case DetorsionMoment::kClipOff:
      return tr("clip off");
    case DetorsionMoment::kVentOpen:
      return tr("gas out");
    case DetorsionMoment::kVentShut:
      return tr("way out closed");
    case DetorsionMoment::kCheck:
      return tr("check");
  }
  return {};
}

QString DetorsionPlot::momentSign(DetorsionMoment moment) {
  switch (moment) {
    case DetorsionMoment::kGrip:
      return QStringLiteral("\u25bc");
    case DetorsionMoment::kLetGo:
      return QStringLiteral("\u25b3");
    case DetorsionMoment::kClipOn:
      return QStringLiteral("\u25a0");
    case DetorsionMoment::kClipOff:
      return QStringLiteral("\u25a1");
    case DetorsionMoment::kVentOpen:
      return QStringLiteral("V");
    case DetorsionMoment::kVentShut:
      return QStringLiteral("v");
    case DetorsionMoment::kCheck:
      return QStringLiteral("?");
  }
  return {};
}

DetorsionPlot::Lane DetorsionPlot::lane(int number, double low, double high) const {
  const double each = (height() - kEventsAbove - kTimeBelow) / kLanes;
  return {QRectF(kLaneLeft, kEventsAbove + number * each + kNameAbove, width() - kLaneLeft - kLaneRight,
                 each - kNameAbove - 4.0),
          low, high};
}

double DetorsionPlot::xOf(double time_s) const {
  const double whole_s = std::max(1e-3, story_.time_s.back());
  return kLaneLeft + time_s / whole_s * (width() - kLaneLeft - kLaneRight);
}

void DetorsionPlot::drawLane(QPainter& painter, const Lane& lane, const QString& name,
                             const std::vector<double>& values, double scale,
                             std::optional<double> limit) const {
  const auto yOf = [&lane](double value) {
    return lane.area.bottom() - (value - lane.low) / (lane.high - lane.low) * lane.area.height();
  };
  const QLocale locale;
  painter.setPen(theme_->quietText);
  painter.drawText(QRectF(0.0, lane.area.top() - kNameAbove, lane.area.right(), kNameAbove - 2.0),
                   Qt::AlignLeft | Qt::AlignVCenter, name);
  const int decimals = lane.high - lane.low < 5.0 ? 1 : 0;
  for (const double value : {lane.low, 0.5 * (lane.low + lane.high), lane.high}) {
    painter.setPen(theme_->line);
    painter.drawLine(QPointF(lane.area.left(), yOf(value)), QPointF(lane.area.right(), yOf(value)));
    painter.setPen(theme_->quietText);
    painter.drawText(QRectF(0.0, yOf(value) - 8.0, kLaneLeft - 6.0, 16.0), Qt::AlignRight | Qt::AlignVCenter,
                     locale.toString(value, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212)));
  }
  if (limit) {
    painter.setPen(QPen(theme_->caution, 1.3, Qt::DashLine));
    painter.drawLine(QPointF(lane.area.left(), yOf(*limit)), QPointF(lane.area.right(), yOf(*limit)));
  }
  QPolygonF curve;
  for (std::size_t i = 0; i < story_.time_s.size(); ++i) {
    curve << QPointF(xOf(story_.time_s[i]), yOf(std::clamp(values[i] * scale, lane.low, lane.high)));
  }
  painter.setPen(QPen(theme_->accent, 1.8));
  painter.drawPolyline(curve);
  painter.setPen(theme_->border);
  painter.drawRect(lane.area);
}

void DetorsionPlot::drawTime(QPainter& painter, double bottom) const {
  painter.setPen(theme_->quietText);
  for (int i = 0; i <= kTimeMarks; ++i) {
    const double at_s = story_.time_s.back() * i / kTimeMarks;
    const Qt::Alignment side = i == 0 ? Qt::AlignLeft : i == kTimeMarks ? Qt::AlignRight : Qt::AlignHCenter;
    const double left = i == 0 ? 0.0 : i == kTimeMarks ? 80.0 : 40.0;
    painter.drawText(QRectF(xOf(at_s) - left, bottom + 2.0, 80.0, 16.0), static_cast<int>(side.toInt()),
                     DetorsionPanel::clockText(at_s * story_.timeScale));
  }
}

void DetorsionPlot::drawEvents(QPainter& painter, double bottom) const {
  QStringList legend;
  double free = -1e9;
  for (const DetorsionStory::Event& event : story_.events) {
    const double x = xOf(event.at_s);
    QColor faint = theme_->quietText;
    faint.setAlphaF(0.35F);
    painter.setPen(QPen(faint, 1.0));
    painter.drawLine(QPointF(x, kEventsAbove), QPointF(x, bottom));
    const QString entry = QStringLiteral("%1 %2").arg(momentSign(event.what), momentName(event.what));
    if (!legend.contains(entry)) {
      legend << entry;
    }
    if (x < free) {
      continue;  // signs would lie over each other; the line remains
    }
    free = x + kSignRoom;
    painter.setPen(theme_->text);
    painter.drawText(QRectF(x - 10.0, 2.0, 20.0, kEventsAbove - 4.0), Qt::AlignCenter,
                     momentSign(event.what));
  }
  painter.setPen(theme_->quietText);
  painter.drawText(QRectF(kLaneLeft, bottom + kLegendBelow, width() - kLaneLeft - kLaneRight, 18.0),
                   Qt::AlignLeft | Qt::AlignVCenter, legend.join(QStringLiteral("    ")));
}

void DetorsionPlot::paintEvent(QPaintEvent*) {
  if (story_.time_s.size() < 2) {
    return;
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont small = font();
  small.setPointSizeF(kSmallText_pt);
  painter.setFont(small);
  double low = 0.0;
  double high = 0.0;
  for (const double angle : story_.angle_rad) {
    low = std::min(low, degrees(angle));
    high = std::max(high, degrees(angle));
  }
  const double dose = *std::max_element(story_.dose.begin(), story_.dose.end());
  low = 90.0 * std::floor(low / 90.0);
  high = std::max(low + 90.0, 90.0 * std::ceil(high / 90.0));
  const Lane last = lane(2, 0.0, std::max(1.0, 1.1 * dose));
  drawLane(painter, lane(0, low, high), tr("Angle in degrees"), story_.angle_rad, kDegreesPerRadian, 0.0);
  drawLane(painter, lane(1, 0.0, 100.0), tr("Blood flow in % of the untwisted organ"), story_.flow, 100.0,
           100.0 * story_.enoughFlow);
  drawLane(painter, last, tr("Ischaemic dose: from 1 on the tissue is lost"), story_.dose, 1.0, 1.0);
  drawTime(painter, last.area.bottom());
  drawEvents(painter, last.area.bottom());
}

}  // namespace torsio::gui
