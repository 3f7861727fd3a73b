// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/level_bar.h"

#include <algorithm>
#include <cmath>

#include <QLocale>
#include <QPainter>

#include "app/gui/widgets/value_text.h"

namespace torsio::gui {

namespace {

constexpr double kBar = 8.0;
constexpr double kRoomBeyondLimit = 1.25;  // the limit is at four fifths of the bar

}  // namespace

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
