// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/stress_legend.h"

#include <algorithm>

#include <QEvent>
#include <QLocale>
#include <QPainter>

#include "app/gui/scene/shear_map.h"

namespace torsio::gui {

namespace {

constexpr int kBarWidth = 14;
constexpr int kBarHeight = 132;
constexpr int kFigures = 3;

}  // namespace

StressLegend::StressLegend(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  describe();
}

void StressLegend::setTop(double top_Pa) {
  top_Pa_ = top_Pa;
  describe();
  update();
}

void StressLegend::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

QString StressLegend::figure(double stress_Pa) const {
  return top_Pa_ >= 1000.0 ? tr("%1 kPa").arg(QLocale().toString(stress_Pa / 1000.0, 'f', 1))
                           : tr("%1 Pa").arg(QLocale().toString(stress_Pa, 'f', 0));
}

void StressLegend::describe() {
  setAccessibleName(tr("Shear stress"));
  setAccessibleDescription(tr("Dark blue is %1, yellow is %2 and more").arg(figure(0.0), figure(top_Pa_)));
}

QSize StressLegend::sizeHint() const {
  const int text = std::max(fontMetrics().horizontalAdvance(figure(top_Pa_)),
                            fontMetrics().horizontalAdvance(tr("Shear stress")) - kBarWidth - kSpace);
  return {kBarWidth + text + 4 * kSpace, kBarHeight + fontMetrics().height() + 3 * kSpace};
}

void StressLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = theme_->surface;
  ground.setAlphaF(0.92F);
  painter.setPen(theme_->line);
  painter.setBrush(ground);
  painter.drawRoundedRect(rect().adjusted(0, 0, -1, -1), 8, 8);
  const int line = fontMetrics().height();
  painter.setPen(theme_->text);
  painter.drawText(QRect(kSpace, kSpace - 2, width() - 2 * kSpace, line), Qt::AlignLeft | Qt::AlignVCenter,
                   tr("Shear stress"));
  // Row by row and without antialiasing, which would mix each colour with the background.
  painter.setRenderHint(QPainter::Antialiasing, false);
  const QRect bar(kSpace, 2 * kSpace + line, kBarWidth, kBarHeight);
  for (int y = 0; y < bar.height(); ++y) {
    const auto colour = shearColour(1.0F - static_cast<float>(y) / static_cast<float>(bar.height() - 1));
    painter.setPen(QColor::fromRgbF(colour[0], colour[1], colour[2]));
    painter.drawLine(bar.left(), bar.top() + y, bar.right(), bar.top() + y);
  }
  painter.setPen(theme_->text);
  for (int i = 0; i < kFigures; ++i) {
    const double share = 1.0 - static_cast<double>(i) / (kFigures - 1);
    const int y = bar.top() + i * (bar.height() - line) / (kFigures - 1);
    painter.drawText(QRect(bar.right() + kSpace, y, width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     figure(share * top_Pa_));
  }
}

void StressLegend::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    describe();
    update();
  }
  QWidget::changeEvent(event);
}

}  // namespace torsio::gui
