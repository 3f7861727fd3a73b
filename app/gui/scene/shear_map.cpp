// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/shear_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <QEvent>
#include <QLocale>
#include <QPainter>

#include "app/gui/widgets/window_events.h"
#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/scene/hollow_organ.h"

namespace torsio::gui {

namespace {

constexpr int kWaySteps = 36;

/// Nunez, Anderton, Renslow: Optimizing colormaps (PLOS ONE 2018), seven equidistant stops of cividis.
constexpr std::array<std::array<float, 3>, 7> kCividis{{{0.000F, 0.135F, 0.305F},
                                                        {0.148F, 0.245F, 0.423F},
                                                        {0.321F, 0.348F, 0.427F},
                                                        {0.482F, 0.482F, 0.471F},
                                                        {0.647F, 0.613F, 0.460F},
                                                        {0.826F, 0.756F, 0.389F},
                                                        {0.995F, 0.909F, 0.218F}}};

constexpr int kBarWidth = 14;
constexpr int kBarHeight = 132;
constexpr int kFigures = 3;

}  // namespace

ShearMap::ShearMap(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {
  const SectionLattice& lattice = scene_->lattice();
  const int ridges = lattice.ridges();
  const int rows = lattice.sections() - 1;
  const auto coordinates = lattice.vertexCoordinates();
  const auto parts = lattice.vertexParts();
  weights_.resize(coordinates.size());
  for (std::size_t v = 0; v < weights_.size(); ++v) {
    if (parts[v] != LatticePart::kSide) {
      continue;
    }
    // In units of patches, from the centre of the first one.
    const double along = coordinates[v].arc_m / lattice.length_m() * rows - 0.5;
    const double about = coordinates[v].angle_rad / kTurn * ridges - 0.5;
    const auto row = static_cast<int>(std::floor(along));
    const auto column = static_cast<int>(std::floor(about));
    const auto s = static_cast<float>(along - row);
    const auto t = static_cast<float>(about - column);
    const auto patch = [&](int j, int k) {
      return std::clamp(j, 0, rows - 1) * ridges + ((k % ridges) + ridges) % ridges;
    };
    weights_[v].patches = {patch(row, column), patch(row, column + 1), patch(row + 1, column),
                           patch(row + 1, column + 1)};
    weights_[v].weights = {(1.0F - s) * (1.0F - t), (1.0F - s) * t, s * (1.0F - t), s * t};
  }
  patch_Pa_.resize(static_cast<std::size_t>(lattice.patches()));
  top_Pa_ = scene_->peakShear_Pa(scene_->stateAt(scene_->pattern.targetAngle_rad));
  if (scene_->hollow) {  // comes twisted; its shear is largest on the way, before it closes
    const double most_rad = scene_->hollow->detorsion().start.most_rad;
    for (int k = 1; k <= kWaySteps; ++k) {
      top_Pa_ = std::max(top_Pa_, scene_->peakShear_Pa(scene_->stateAt(most_rad * k / kWaySteps)));
    }
  }
}

void ShearMap::evaluate(const OrganState& state, std::span<float> share) {
  TORSIO_EXPECTS(share.size() == weights_.size());
  scene_->patchShear(state, patch_Pa_);
  const float scale = top_Pa_ > 0.0 ? static_cast<float>(1.0 / top_Pa_) : 0.0F;
  for (std::size_t v = 0; v < share.size(); ++v) {
    float stress_Pa = 0.0F;
    for (std::size_t k = 0; k < 4; ++k) {
      stress_Pa += weights_[v].weights[k] *
                   static_cast<float>(patch_Pa_[static_cast<std::size_t>(weights_[v].patches[k])]);
    }
    share[v] = std::clamp(stress_Pa * scale, 0.0F, 1.0F);
  }
}

std::array<float, 3> shearColour(float share) noexcept {
  const float place = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(kCividis.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kCividis.size() - 2);
  const float t = place - static_cast<float>(below);
  std::array<float, 3> colour{};
  for (std::size_t k = 0; k < 3; ++k) {
    colour[k] = kCividis[below][k] * (1.0F - t) + kCividis[below + 1][k] * t;
  }
  return colour;
}

StressLegend::StressLegend(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  followLanguage(this, [this] {
    describe();
    update();
  });
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

}  // namespace torsio::gui
