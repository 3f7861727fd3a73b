// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/surroundings.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include "app/gui/scene/neighbours.h"
#include "app/gui/widgets/theme.h"
#include "sim/scene/tissue_look.h"

namespace torsio::gui {

namespace {

constexpr int kSide_px = 1024;
constexpr int kGround_px = 512;
// In radii of the organ: the arm table, the towel on it, and the retractor ring.
constexpr double kTable = 1.42;
constexpr double kTowelRight = 0.62;
constexpr double kTowelUp = 1.62;
constexpr double kRingRight = 1.78;
constexpr double kRingUp = 1.52;

double eased(double low, double high, double value) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Cloth is green-blue; tissue in shade is pale or dark with the theme, never as red as the organ.
QColor towelOf(const Theme& theme) {
  return theme.kind == ThemeKind::kDark ? QColor(0x2A, 0x4A, 0x50) : QColor(0xC2, 0xDC, 0xDB);
}

QColor cavityOf(const Theme& theme) {
  return theme.kind == ThemeKind::kDark ? QColor(0x2B, 0x24, 0x29) : QColor(0xD6, 0xCA, 0xCF);
}

/// Height of the cloth, in radii: broad folds down the table, and small ones across.
double clothHeight(double u, double v) {
  return 0.026 * static_cast<double>(tissueNoise({1.9 * u, 0.55 * v, 0.0})) +
         0.0075 * static_cast<double>(tissueNoise({5.2 * u + 1.5 * v, 1.7 * v - u, 7.0})) +
         0.00045 * static_cast<double>(tissueNoise({27.0 * u, 25.0 * v, 3.0}));
}

/// Brightness of the cloth, lit from the upper left: slopes and fold creases.
double clothLight(double u, double v) {
  constexpr double kStep = 0.012;
  constexpr double kCrease = 1.06;  // between creases
  const double right = (clothHeight(u + kStep, v) - clothHeight(u - kStep, v)) / (2.0 * kStep);
  const double up = (clothHeight(u, v + kStep) - clothHeight(u, v - kStep)) / (2.0 * kStep);
  double light = 1.0 - 0.95 * right + 0.75 * up;
  for (const double way : {u - 0.97, v + 0.35}) {
    const double away = std::remainder(way, 2.0 * kCrease) / 0.016;
    light += 0.035 * away * std::exp(-0.5 * away * away);  // light on one side, shade on the other
  }
  return light;
}

/// Light of the operating lamp.
double lampLight(double u, double v) {
  return 1.07 - 0.17 * eased(0.35, 2.1, std::hypot(u + 0.12, v - 0.15));
}

QRgb shown(const QColor& colour, double light) {
  const auto channel = [light](int value) {
    return static_cast<int>(std::clamp(light * value + 0.5, 0.0, 255.0));
  };
  return qRgb(channel(colour.red()), channel(colour.green()), channel(colour.blue()));
}

/// Shade of the draped upper arm on the table beside it.
double shadeOfUpperArm(double u, double v) {
  const double beside = (u - 0.13) / 0.26;
  return 0.34 * std::exp(-beside * beside) * eased(0.62, 1.05, -v);
}

QRgb drapeAt(double u, double v, const Theme& theme, bool arm) {
  // Beyond the table, it hangs down into the dark.
  const double edge = kTable + 0.03 * static_cast<double>(tissueNoise({1.3 * v, 2.0, u > 0.0 ? 1.0 : 5.0}));
  const double over = std::abs(u) - edge;
  const double hangs = eased(-0.02, 0.05, over);
  double light = clothLight(u, v) * lampLight(u, v) * (1.0 - hangs * (0.34 + 0.20 * eased(0.0, 1.2, over)));
  light += 0.07 * std::exp(-0.5 * std::pow((over + 0.05) / 0.03, 2.0));  // at the edge of the table
  // A towel under the limb: its hem, with a narrow shade round it.
  const double outside = std::max(std::abs(u) - kTowelRight, std::abs(v) - kTowelUp);
  const double towel = 1.0 - eased(-0.004, 0.010, outside);
  light *= 1.0 - 0.16 * (1.0 - towel) * std::exp(-std::max(outside, 0.0) / 0.035);
  light -= 0.05 * towel * std::exp(-0.5 * std::pow((outside + 0.045) / 0.006, 2.0));
  light *= arm ? 1.0 - shadeOfUpperArm(u, v) : 1.0;
  const QColor cloth = clothColour(theme);
  const QColor towelling = towelOf(theme);
  const auto mixed = [towel](int a, int b) { return static_cast<int>(a + towel * (b - a)); };
  return shown(QColor(mixed(cloth.red(), towelling.red()), mixed(cloth.green(), towelling.green()),
                      mixed(cloth.blue(), towelling.blue())),
               light);
}

QRgb cavityAt(double u, double v, const Theme& theme) {
  const double ring = std::hypot(u / kRingRight, v / kRingUp);
  if (ring > 1.0) {
    return shown(clothColour(theme),
                 clothLight(u, v) * lampLight(u, v) * (0.80 + 0.10 * eased(1.0, 1.2, ring)));
  }
  // Two lattices at an angle: a single one would show squares.
  const double uneven = 0.020 * static_cast<double>(tissueNoise({2.1 * u + 0.9 * v, 2.2 * v - u, 0.0})) +
                        0.018 * static_cast<double>(tissueNoise({1.2 * u - 2.6 * v, 2.4 * u + v, 4.0})) +
                        0.007 * static_cast<double>(tissueNoise({7.0 * u + 4.0 * v, 6.0 * v - 5.0 * u, 7.0}));
  return shown(cavityOf(theme), (1.0 + uneven) * (lampLight(u, v) - 0.32 * eased(0.72, 1.0, ring)));
}

QImage paintGround(Surroundings kind, const Theme& theme) {
  QImage image(kGround_px, kGround_px, QImage::Format_RGB32);
  const auto place = [](int pixel) {
    return static_cast<double>(kSurroundingsReach) * (2.0 * (pixel + 0.5) / kGround_px - 1.0);
  };
  for (int y = 0; y < kGround_px; ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < kGround_px; ++x) {
      line[x] = throughPort(kind) ? cavityAt(place(x), -place(y), theme)
                                  : drapeAt(place(x), -place(y), theme, kind == Surroundings::kArm);
    }
  }
  return image.scaled(kSide_px, kSide_px, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

/// Draws the steel ring that holds the abdomen open.
void drawRing(QPainter& painter, const Theme& theme) {
  const bool dark = theme.kind == ThemeKind::kDark;
  painter.setBrush(Qt::NoBrush);
  const auto ring = [&](const QColor& colour, double width, double shift) {
    painter.setPen(QPen(colour, width));
    painter.drawEllipse(QPointF(-shift, shift), kRingRight, kRingUp);
  };
  ring(QColor(0, 0, 0, dark ? 110 : 60), 0.13, -0.045);
  ring(dark ? QColor(0x3C, 0x45, 0x4C) : QColor(0x8F, 0x9B, 0xA3), 0.105, 0.0);
  ring(dark ? QColor(0x66, 0x72, 0x7B) : QColor(0xC9, 0xD2, 0xD8), 0.062, 0.008);
  ring(dark ? QColor(0x9A, 0xA6, 0xAE) : QColor(0xF4, 0xF7, 0xF9), 0.020, 0.020);
}

}  // namespace

Surroundings surroundingsOf(std::string_view sceneId, bool former) {
  if (sceneId == "gastric-mesentero-axial") {
    return former ? Surroundings::kBareTurnedAntrum : Surroundings::kTurnedAntrum;
  }
  if (sceneId == "stomach" || sceneId.starts_with("gastric")) {
    return former ? Surroundings::kBareStomach : Surroundings::kStomach;
  }
  if (sceneId == "sigmoid") {
    return Surroundings::kPelvis;
  }
  if (sceneId == "intestine" || sceneId == "small-bowel-loop") {
    return Surroundings::kBowelLoop;
  }
  if (sceneId == "midgut") {
    return Surroundings::kIntestine;
  }
  return sceneId == "forearm" ? Surroundings::kArm : Surroundings::kDrape;
}

QColor clothColour(const Theme& theme) {
  return theme.kind == ThemeKind::kDark ? QColor(0x1E, 0x3E, 0x41) : QColor(0xAE, 0xCF, 0xCC);
}

bool throughPort(Surroundings kind) noexcept {
  return kind != Surroundings::kDrape && kind != Surroundings::kArm;
}

QImage paintSurroundings(Surroundings kind, const Theme& theme) {
  QImage picture = paintGround(kind, theme).convertToFormat(QImage::Format_RGB32);
  if (throughPort(kind)) {
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(0.5 * kSide_px, 0.5 * kSide_px);
    const double scale = 0.5 * kSide_px / static_cast<double>(kSurroundingsReach);
    painter.scale(scale, -scale);
    QPainterPath opening;
    opening.addEllipse(QPointF(0.0, 0.0), kRingRight, kRingUp);
    painter.setClipPath(opening);
    drawNeighbours(painter, kind, theme);
    painter.setClipping(false);
    drawRing(painter, theme);
  }
  return picture;
}

void SurroundingsTexture::setPicture(const QImage& picture) {
  const QImage turned = picture.convertToFormat(QImage::Format_RGBA8888).mirrored();
  setSize(turned.size());
  setFormat(RGBA8);
  setHasTransparency(picture.hasAlphaChannel());
  setTextureData(QByteArray(reinterpret_cast<const char*>(turned.constBits()), turned.sizeInBytes()));
}

}  // namespace torsio::gui
