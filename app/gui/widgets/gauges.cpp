// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/gauges.h"

#include <algorithm>
#include <cmath>

#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include "app/gui/widgets/value_text.h"
#include "sim/core/angle.h"

namespace torsio::gui {

namespace {

constexpr int kDiameter = 146;
constexpr double kRing = 10.0;
constexpr double kHeldRing = 4.0;
constexpr double kTargetReach = 5.0;  // length of the target's mark outside of the ring
constexpr double kLeastTolerance_deg = 1.0;

/// Draws an arc from the top, clockwise for positive angles.
void drawArc(QPainter& painter, const QRectF& box, double from_deg, double span_deg) {
  painter.drawArc(box, static_cast<int>(std::lround((90.0 - from_deg) * 16.0)),
                  static_cast<int>(std::lround(-span_deg * 16.0)));
}

constexpr double kBar = 8.0;
constexpr double kRoomBeyondLimit = 1.25;  // the limit is at four fifths of the bar

}  // namespace

AngleDial::AngleDial(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  retranslate();
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  describe();
}

QSize AngleDial::sizeHint() const {
  return {kDiameter + 16, kDiameter + 8};
}

void AngleDial::retranslate() {
  setAccessibleName(tr("Twist angle"));
  describe();
  update();
}

void AngleDial::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void AngleDial::setTarget(double target_rad, double tolerance_rad) {
  if (target_rad == target_rad_ && tolerance_rad == tolerance_rad_) {
    return;
  }
  target_rad_ = target_rad;
  tolerance_rad_ = tolerance_rad;
  describe();
  update();
}

void AngleDial::setAngle(double angle_rad) {
  // The number shows tenths of a degree; finer changes would only repaint.
  if (std::lround(degrees(angle_rad) * 10.0) == std::lround(degrees(angle_rad_) * 10.0)) {
    return;
  }
  angle_rad_ = angle_rad;
  describe();
  update();
}

bool AngleDial::onTarget() const noexcept {
  return target_rad_ != 0.0 && std::abs(angle_rad_ - target_rad_) <= tolerance_rad_;
}

void AngleDial::setHeld(double share) {
  const double held = std::clamp(share, 0.0, 1.0);
  if (held != held_) {
    held_ = held;
    update();
  }
}

void AngleDial::describe() {
  setAccessibleDescription(tr("%1\u00b0, target %2\u00b0")
                               .arg(degrees(angle_rad_), 0, 'f', 1)
                               .arg(degrees(target_rad_), 0, 'f', 0));
}

void AngleDial::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF centre = rect().center() + QPointF(0.5, 0.5);
  const double radius = 0.5 * kDiameter - kTargetReach - 0.5 * kRing;
  const QRectF ring(centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius);
  const double angle_deg = degrees(angle_rad_);
  const double target_deg = degrees(target_rad_);

  painter.setPen(QPen(theme_->track, kRing, Qt::SolidLine, Qt::FlatCap));
  painter.drawEllipse(ring);
  const QColor way = onTarget() ? theme_->good : theme_->accent;
  painter.setPen(QPen(way, kRing, Qt::SolidLine, Qt::FlatCap));
  drawArc(painter, ring, 0.0, std::clamp(angle_deg, -360.0, 360.0));

  if (held_ > 0.0) {
    const double within = radius - 0.5 * kRing - kHeldRing;
    painter.setPen(QPen(theme_->good, kHeldRing, Qt::SolidLine, Qt::RoundCap));
    drawArc(painter, QRectF(centre.x() - within, centre.y() - within, 2.0 * within, 2.0 * within), 0.0,
            360.0 * held_);
  }

  if (target_rad_ != 0.0) {
    const double half_deg = std::max(degrees(tolerance_rad_), kLeastTolerance_deg);
    const double outside = radius + 0.5 * kRing + 3.0;
    const QRectF rail(centre.x() - outside, centre.y() - outside, 2.0 * outside, 2.0 * outside);
    painter.setPen(QPen(theme_->text, 3.0, Qt::SolidLine, Qt::FlatCap));
    drawArc(painter, rail, target_deg - half_deg, 2.0 * half_deg);
    painter.save();
    painter.translate(centre);
    painter.rotate(target_deg);
    painter.setPen(QPen(theme_->text, 2.0));
    painter.drawLine(QPointF(0.0, -(radius - 0.5 * kRing - 3.0)), QPointF(0.0, -outside));
    painter.restore();
  }

  QFont figure = font();
  figure.setPointSizeF(kFigureText_pt);
  figure.setWeight(QFont::DemiBold);
  const QRectF inside = ring.adjusted(0.5 * kRing, kRing, -0.5 * kRing, -kRing);
  const QString text = numberText(angle_deg, 1) + QChar(0x00B0);
  const double room = inside.width() - 2.0 * kRing;  // a wide font would overlap the ring
  const double wide = QFontMetricsF(figure).horizontalAdvance(text);
  figure.setPointSizeF(kFigureText_pt * std::min(1.0, room / wide));
  painter.setFont(figure);
  painter.setPen(theme_->text);
  const double line = QFontMetricsF(figure).height();
  painter.drawText(QRectF(inside.left(), centre.y() - 0.62 * line, inside.width(), line), Qt::AlignCenter,
                   text);
  QFont small = font();
  small.setPointSizeF(kSmallText_pt);
  painter.setFont(small);
  painter.setPen(onTarget() ? theme_->good : theme_->quietText);
  const QString below =
      onTarget() ? tr("on target") : tr("target %1").arg(numberText(target_deg, 0)) + QChar(0x00B0);
  painter.drawText(
      QRectF(inside.left(), centre.y() + 0.32 * line, inside.width(), 1.0 + QFontMetricsF(small).height()),
      Qt::AlignHCenter | Qt::AlignTop, below);
}

LevelBar::LevelBar(const QString& name, const QString& unit, int decimals, QWidget* parent)
    : QWidget(parent), theme_(&theme(ThemeKind::kLight)), name_(name), unit_(unit), decimals_(decimals) {
  setAccessibleName(name);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  describe();
}

QSize LevelBar::sizeHint() const {
  return {200, fontMetrics().height() + 6 + static_cast<int>(kBar) + 6};
}

void LevelBar::setName(const QString& name, const QString& unit) {
  name_ = name;
  unit_ = unit;
  setAccessibleName(name);
  describe();
  update();
}

void LevelBar::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void LevelBar::setLimit(double limit) {
  limit_ = limit;
  describe();
  update();
}

void LevelBar::setValue(double value) {
  const double step = std::pow(10.0, decimals_);
  if (std::lround(value * step) == std::lround(value_ * step)) {
    return;
  }
  value_ = value;
  describe();
  update();
}

QString LevelBar::figure() const {
  return numberText(value_, decimals_) + QChar(0x00A0) + unit_;
}

void LevelBar::describe() {
  setAccessibleDescription(overLimit() ? tr("%1, above the limit").arg(figure()) : figure());
}

void LevelBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double line = fontMetrics().height();
  const QRectF words(0.0, 0.0, width(), line);
  painter.setPen(theme_->quietText);
  painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, name_);
  QFont strong = font();
  strong.setWeight(QFont::DemiBold);
  painter.setFont(strong);
  painter.setPen(overLimit() ? theme_->caution : theme_->text);
  painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter,
                   overLimit() ? tr("above limit  %1").arg(figure()) : figure());

  const QRectF track(0.5, line + 6.0, width() - 1.0, kBar);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_->track);
  painter.drawRoundedRect(track, 0.5 * kBar, 0.5 * kBar);
  const double full = limit_ > 0.0 ? kRoomBeyondLimit * limit_ : 1.0;
  const double share = std::clamp(value_ / full, 0.0, 1.0);
  if (share > 0.0) {
    painter.setBrush(overLimit() ? theme_->caution : theme_->accent);
    painter.drawRoundedRect(QRectF(track.left(), track.top(), std::max(kBar, share * track.width()), kBar),
                            0.5 * kBar, 0.5 * kBar);
  }
  if (limit_ > 0.0) {
    const double x = track.left() + track.width() / kRoomBeyondLimit;
    painter.setPen(QPen(theme_->caution, 2.0));
    painter.drawLine(QPointF(x, track.top() - 3.0), QPointF(x, track.bottom() + 3.0));
  }
}

}  // namespace torsio::gui
