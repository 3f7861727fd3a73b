// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/debrief_plot.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/value_text.h"
#include "sim/core/angle.h"
#include "sim/core/load_decimals.h"

namespace torsio::gui {

namespace {

constexpr double kLeft = 58.0;
constexpr double kRight = 16.0;
constexpr double kTop = 22.0;
constexpr double kBottom = 26.0;
constexpr double kBetween = 26.0;
constexpr double kRoomRound_s = 1.5;
constexpr double kShortest_s = 0.5;

/// Returns 1, 2 or 5 times a power of ten, at least `least`.
double niceStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(least, 1e-9))));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

}  // namespace

DebriefPlot::DebriefPlot(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  retranslate();
}

void DebriefPlot::setDebrief(Debrief debrief) {
  debrief_ = std::move(debrief);
  marked_.reset();
  position_s_ = 0.0;
  showAll();
  retranslate();
}

void DebriefPlot::addBookmark(const DebriefBookmark& mark) {
  debrief_.bookmarks.push_back(mark);
  update();
}

void DebriefPlot::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void DebriefPlot::setExpertVisible(bool visible) {
  expertVisible_ = visible;
  update();
}

void DebriefPlot::setPosition(double at_s) {
  position_s_ = at_s;
  update();
}

QString DebriefPlot::reading() const {
  const DebriefTrace& own = debrief_.own;
  if (own.empty()) {
    return {};
  }
  // The sample at the playhead: the last one that is not later.
  const auto after = std::upper_bound(own.time_s.begin(), own.time_s.end(), position_s_);
  const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - own.time_s.begin() - 1, 0));
  return tr("%1   %2\u00b0   %3 N")
      .arg(clockTenths(position_s_), numberText(degrees(own.angle_rad[at]), 0),
           numberText(own.force_N[at], kForceDecimals));
}

void DebriefPlot::show(const Seconds& when) {
  marked_ = when;
  range_ = {std::max(0.0, when.from_s - kRoomRound_s),
            std::min(debrief_.duration_s, when.to_s + kRoomRound_s)};
  if (range_.to_s - range_.from_s < kShortest_s) {
    range_.to_s = range_.from_s + kShortest_s;
  }
  update();
}

void DebriefPlot::showAll() {
  range_ = {0.0, std::max(kShortest_s, debrief_.duration_s)};
  update();
}

void DebriefPlot::retranslate() {
  setAccessibleName(tr("Angle and force of the run over time"));
  setAccessibleDescription(
      tr("Twists: %1, in %2. Plus and minus zoom, arrows move, Enter goes to the middle, B sets a "
         "bookmark.")
          .arg(debrief_.twists.size())
          .arg(clockTenths(debrief_.duration_s)));
  setToolTip(tr("Wheel zooms, dragging moves, a double click sets a bookmark"));
  update();
}

double DebriefPlot::xOf(double time_s) const {
  const double span = range_.to_s - range_.from_s;
  return kLeft + (time_s - range_.from_s) / span * (width() - kLeft - kRight);
}

double DebriefPlot::timeOf(double x) const {
  const double share = (x - kLeft) / std::max(1.0, width() - kLeft - kRight);
  return std::clamp(range_.from_s + share * (range_.to_s - range_.from_s), 0.0, debrief_.duration_s);
}

double DebriefPlot::yOf(const Lane& lane, double value) {
  return lane.area.bottom() - (value - lane.low) / (lane.high - lane.low) * lane.area.height();
}

DebriefPlot::Lane DebriefPlot::angleLane() const {
  const double span = height() - kTop - kBottom - kBetween;
  Lane lane{QRectF(kLeft, kTop, width() - kLeft - kRight, span * 0.66), 0.0, 0.0};
  for (const double angle : debrief_.own.angle_rad) {
    lane.low = std::min(lane.low, degrees(angle));
    lane.high = std::max(lane.high, degrees(angle));
  }
  const double target = degrees(debrief_.target_rad);
  const double band = degrees(debrief_.tolerance_rad);
  lane.low = std::min(lane.low, target - band);
  lane.high = std::max(lane.high, target + band);
  const double room = 0.08 * std::max(10.0, lane.high - lane.low);
  lane.low -= room;
  lane.high += room;
  return lane;
}

DebriefPlot::Lane DebriefPlot::forceLane() const {
  const double span = height() - kTop - kBottom - kBetween;
  Lane lane{QRectF(kLeft, kTop + span * 0.66 + kBetween, width() - kLeft - kRight, span * 0.34), 0.0, 0.5};
  for (const double force : debrief_.own.force_N) {
    lane.high = std::max(lane.high, force);
  }
  lane.high = std::max(lane.high, debrief_.forceLimit_N) * 1.15;
  return lane;
}

void DebriefPlot::drawCurve(QPainter& painter, const Lane& lane, const std::vector<double>& time_s,
                            const std::vector<double>& values, double scale, double offset_s) const {
  QPolygonF line;
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    const double at = time_s[i] + offset_s;
    if (at < range_.from_s - 1.0 || at > range_.to_s + 1.0) {
      continue;
    }
    line << QPointF(xOf(at), yOf(lane, values[i] * scale));
  }
  painter.drawPolyline(line);
}

void DebriefPlot::drawAxes(QPainter& painter, const Lane& angle, const Lane& force) const {
  QFont small = font();
  small.setPointSizeF(kSmallText_pt);
  painter.setFont(small);
  const auto scale = [&](const Lane& lane, const QString& name, double least) {
    painter.setPen(theme_->quietText);
    painter.drawText(QRectF(0.0, lane.area.top() - 20.0, lane.area.right(), 16.0),
                     Qt::AlignLeft | Qt::AlignVCenter, name);
    const double step = niceStep(std::max(least, (lane.high - lane.low) / 4.0));
    for (double v = std::ceil(lane.low / step) * step; v <= lane.high; v += step) {
      const double y = yOf(lane, v);
      painter.setPen(theme_->line);
      painter.drawLine(QPointF(lane.area.left(), y), QPointF(lane.area.right(), y));
      painter.setPen(theme_->quietText);
      painter.drawText(QRectF(0.0, y - 9.0, kLeft - 8.0, 18.0), Qt::AlignRight | Qt::AlignVCenter,
                       numberText(v, step < 1.0 ? 1 : 0));
    }
  };
  scale(angle, tr("Angle in degrees"), 5.0);
  scale(force, tr("Force in N"), 0.5);
  const double step = niceStep((range_.to_s - range_.from_s) / 8.0);
  painter.setPen(theme_->quietText);
  for (double t = std::ceil(range_.from_s / step) * step; t <= range_.to_s; t += step) {
    // Centred below its time, but not clipped at the end of the run.
    const QString time = clockTenths(t);
    const double wide = painter.fontMetrics().horizontalAdvance(time) + 2.0;
    const double left = std::min(xOf(t) - 0.5 * wide, width() - wide);
    painter.drawText(QRectF(left, force.area.bottom() + 4.0, wide, 18.0), Qt::AlignHCenter, time);
  }
}

void DebriefPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Lane angle = angleLane();
  const Lane force = forceLane();
  drawAxes(painter, angle, force);
  painter.save();
  painter.setClipRect(QRectF(kLeft, 0.0, width() - kLeft - kRight, height()));
  if (marked_) {
    QColor shade = theme_->accent;
    shade.setAlphaF(0.14F);
    painter.fillRect(QRectF(QPointF(xOf(marked_->from_s), angle.area.top()),
                            QPointF(xOf(marked_->to_s), force.area.bottom())),
                     shade);
  }
  if (debrief_.target_rad != 0.0) {
    QColor band = theme_->good;
    band.setAlphaF(0.20F);
    painter.fillRect(QRectF(QPointF(kLeft, yOf(angle, degrees(debrief_.target_rad + debrief_.tolerance_rad))),
                            QPointF(angle.area.right(),
                                    yOf(angle, degrees(debrief_.target_rad - debrief_.tolerance_rad)))),
                     band);
  }
  if (debrief_.forceLimit_N > 0.0) {
    painter.setPen(QPen(theme_->caution, 1.5, Qt::DashLine));
    painter.drawLine(QPointF(kLeft, yOf(force, debrief_.forceLimit_N)),
                     QPointF(force.area.right(), yOf(force, debrief_.forceLimit_N)));
  }
  if (expertVisible_ && !debrief_.expert.empty()) {
    painter.setPen(QPen(theme_->quietText, 1.6, Qt::DashLine));
    for (const double grip_s : debrief_.grips_s) {
      drawCurve(painter, angle, debrief_.expert.time_s, debrief_.expert.angle_rad, kDegreesPerRadian, grip_s);
    }
  }
  painter.setPen(QPen(theme_->accent, 2.0));
  drawCurve(painter, angle, debrief_.own.time_s, debrief_.own.angle_rad, kDegreesPerRadian, 0.0);
  painter.setPen(QPen(theme_->accent, 1.4));
  drawCurve(painter, force, debrief_.own.time_s, debrief_.own.force_N, 1.0, 0.0);
  for (const DebriefBookmark& mark : debrief_.bookmarks) {
    const double x = xOf(mark.at_s);
    painter.setPen(QPen(theme_->text, 1.2));
    painter.drawLine(QPointF(x, angle.area.top()), QPointF(x, force.area.bottom()));
    painter.setBrush(theme_->text);
    painter.drawPolygon(QPolygonF({QPointF(x, angle.area.top()), QPointF(x + 10.0, angle.area.top() + 5.0),
                                   QPointF(x, angle.area.top() + 10.0)}));
    painter.setBrush(Qt::NoBrush);
  }
  const double head = xOf(position_s_);
  painter.setPen(QPen(theme_->text, 2.0));
  painter.drawLine(QPointF(head, angle.area.top()), QPointF(head, force.area.bottom()));
  painter.restore();
  painter.setPen(theme_->text);
  painter.drawText(QRectF(angle.area.left(), angle.area.top() - 20.0, angle.area.width(), 16.0),
                   Qt::AlignRight | Qt::AlignVCenter, reading());
  painter.setPen(theme_->border);
  painter.drawRect(angle.area);
  painter.drawRect(force.area);
  if (hasFocus()) {
    painter.setPen(QPen(theme_->accent, 2.0));
    painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
  }
}

void DebriefPlot::zoom(double factor, double at_s) {
  const double all = std::max(kShortest_s, debrief_.duration_s);
  const double span = std::clamp((range_.to_s - range_.from_s) * factor, kShortest_s, all);
  const double share = (at_s - range_.from_s) / (range_.to_s - range_.from_s);
  range_.from_s = std::clamp(at_s - share * span, 0.0, all - span);
  range_.to_s = range_.from_s + span;
  update();
}

void DebriefPlot::move(double by_s) {
  const double span = range_.to_s - range_.from_s;
  range_.from_s = std::clamp(range_.from_s + by_s, 0.0, std::max(0.0, debrief_.duration_s - span));
  range_.to_s = range_.from_s + span;
  update();
}

void DebriefPlot::wheelEvent(QWheelEvent* event) {
  zoom(event->angleDelta().y() > 0 ? 0.8 : 1.25, timeOf(event->position().x()));
  event->accept();
}

void DebriefPlot::mousePressEvent(QMouseEvent* event) {
  dragFrom_s_ = timeOf(event->position().x());
  dragged_ = false;
}

void DebriefPlot::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !dragged_) {
    Q_EMIT soughtTo(timeOf(event->position().x()));
  }
}

void DebriefPlot::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) {
    dragged_ = true;
    move(dragFrom_s_ - timeOf(event->position().x()));
  }
}

void DebriefPlot::mouseDoubleClickEvent(QMouseEvent* event) {
  Q_EMIT bookmarkWanted(timeOf(event->position().x()));
}

void DebriefPlot::keyPressEvent(QKeyEvent* event) {
  const double middle = 0.5 * (range_.from_s + range_.to_s);
  const double step = 0.1 * (range_.to_s - range_.from_s);
  switch (event->key()) {
    case Qt::Key_Plus:
      return zoom(0.8, middle);
    case Qt::Key_Minus:
      return zoom(1.25, middle);
    case Qt::Key_Left:
      return move(-step);
    case Qt::Key_Right:
      return move(step);
    case Qt::Key_0:
      return showAll();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      Q_EMIT soughtTo(middle);
      return;
    case Qt::Key_B:
      Q_EMIT bookmarkWanted(position_s_);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace torsio::gui
