// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QPainter>
#include <QPainterPath>
#include <QPointF>

#include "app/gui/scene/tissue_look.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kSide_px = 768;
constexpr int kCloth_px = 256;   // folds are broad
constexpr int kShadow_px = 192;  // and the shadow is soft
constexpr double kShadowDepth = 0.38;
constexpr double kShadowRight = 0.07;  // radii: the lamp stands at the upper left
constexpr double kShadowDown = 0.08;

bool onDrape(Surroundings kind) {
  return kind == Surroundings::kDrape;
}

/// Cloth is green-blue, tissue out of the light is pale or dark with the theme, never as red as the organ.
QColor groundOf(Surroundings kind, const Theme& theme) {
  const bool dark = theme.kind == ThemeKind::kDark;
  if (onDrape(kind)) {
    return dark ? QColor(0x1D, 0x38, 0x3B) : QColor(0xB3, 0xD0, 0xCE);
  }
  return dark ? QColor(0x2B, 0x24, 0x29) : QColor(0xDA, 0xCF, 0xD3);
}

QColor outlineOf(const Theme& theme) {
  return theme.kind == ThemeKind::kDark ? QColor(0x47, 0x3B, 0x42) : QColor(0xBD, 0xAC, 0xB3);
}

/// Folds of cloth, or the unevenness of tissue: brightness about 1.
QImage unevenGround(Surroundings kind, const Theme& theme) {
  const QColor ground = groundOf(kind, theme);
  const double depth = onDrape(kind) ? 0.075 : 0.05;
  QImage image(kCloth_px, kCloth_px, QImage::Format_RGB32);
  for (int y = 0; y < kCloth_px; ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < kCloth_px; ++x) {
      const double u = 2.0 * x / kCloth_px - 1.0;
      const double v = 2.0 * y / kCloth_px - 1.0;
      // Cloth folds run down the table; tissue has no direction.
      const double along = onDrape(kind) ? 0.6 : 2.4;
      const double fold =
          tissueNoise({3.0 * u, along * v, 0.0}) + 0.4 * tissueNoise({8.0 * u, 2.6 * along * v, 7.0});
      const double rim = std::clamp(std::hypot(u, v) - 0.25, 0.0, 1.0);
      const double light = 1.0 + depth * fold - 0.22 * rim;
      const auto channel = [light](int value) {
        return static_cast<int>(std::clamp(light * value, 0.0, 255.0));
      };
      line[x] = qRgb(channel(ground.red()), channel(ground.green()), channel(ground.blue()));
    }
  }
  return image.scaled(kSide_px, kSide_px, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

/// Neighbours in units of the organ's radius, y upwards, as a surgeon at the patient's right sees them.
void drawOutlines(QPainter& painter, Surroundings kind, const Theme& theme) {
  const QColor outline = outlineOf(theme);
  QColor fill = outline;
  fill.setAlphaF(0.35F);
  painter.setPen(QPen(outline, 0.025, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(fill);
  if (kind == Surroundings::kStomach) {
    QPainterPath liver(QPointF(-2.6, 0.2));
    liver.cubicTo(-2.5, 1.7, -1.0, 1.9, 0.5, 1.35);
    liver.cubicTo(-0.1, 0.9, -0.9, 0.75, -1.2, 0.1);
    liver.cubicTo(-1.5, -0.5, -2.4, -0.6, -2.6, 0.2);
    painter.drawPath(liver);
    QPainterPath spleen(QPointF(1.5, 1.1));
    spleen.cubicTo(2.2, 1.3, 2.4, 0.4, 1.9, -0.1);
    spleen.cubicTo(1.6, 0.1, 1.5, 0.6, 1.5, 1.1);
    painter.drawPath(spleen);
    QPainterPath colon(QPointF(-2.3, -1.45));
    for (int bulge = 0; bulge < 9; ++bulge) {
      const double x = -2.3 + 0.5 * bulge;
      colon.quadTo(x + 0.25, -1.2, x + 0.5, -1.45);
    }
    for (int bulge = 9; bulge > 0; --bulge) {
      const double x = -2.3 + 0.5 * bulge;
      colon.quadTo(x - 0.25, -2.05, x - 0.5, -1.8);
    }
    colon.closeSubpath();
    painter.drawPath(colon);
    return;
  }
  painter.setBrush(Qt::NoBrush);
  for (int loop = 0; loop < 7; ++loop) {
    const double y = 1.9 - 0.62 * loop;
    QPainterPath bowel(QPointF(-2.5, y));
    for (int bend = 0; bend < 5; ++bend) {
      const double x = -2.5 + 1.0 * bend;
      const double way = (bend + loop) % 2 == 0 ? 0.34 : -0.34;
      bowel.cubicTo(x + 0.3, y + way, x + 0.7, y + way, x + 1.0, y);
    }
    painter.setPen(QPen(fill, 0.46, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(bowel);
    painter.setPen(QPen(outline, 0.02));
    painter.drawPath(bowel.translated(0.0, 0.22));
  }
}

/// The rim of the opened abdomen, held by a ring.
void drawRim(QPainter& painter, const Theme& theme) {
  const QColor steel = theme.kind == ThemeKind::kDark ? QColor(0x5A, 0x64, 0x6C) : QColor(0xF0, 0xF3, 0xF5);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.backdropBottom, 0.9));
  painter.drawEllipse(QPointF(0.0, 0.0), 3.25, 2.95);
  painter.setPen(QPen(steel, 0.09));
  painter.drawEllipse(QPointF(0.0, 0.0), 2.82, 2.52);
}

/// Means over squares, three times over: nearly a bell.
QImage softened(const QImage& sharp) {
  constexpr int kReach = 5;
  QImage soft = sharp;
  for (int pass = 0; pass < 6; ++pass) {
    const bool across = pass % 2 == 0;
    QImage next(soft.size(), QImage::Format_Grayscale8);
    for (int y = 0; y < soft.height(); ++y) {
      for (int x = 0; x < soft.width(); ++x) {
        int sum = 0;
        for (int k = -kReach; k <= kReach; ++k) {
          const int px = std::clamp(across ? x + k : x, 0, soft.width() - 1);
          const int py = std::clamp(across ? y : y + k, 0, soft.height() - 1);
          sum += soft.constScanLine(py)[px];
        }
        next.scanLine(y)[x] = static_cast<uchar>(sum / (2 * kReach + 1));
      }
    }
    soft = next;
  }
  return soft;
}

/// How much of the lamp the organ takes, 0 to 255, over the square.
QImage shadowOf(const OrganSurface& organ, const QVector3D& centre_mm, float radius_mm) {
  QImage shade(kShadow_px, kShadow_px, QImage::Format_Grayscale8);
  shade.fill(0);
  QPainter painter(&shade);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(Qt::white);
  const double scale = 0.5 * kShadow_px / (kSurroundingsReach * radius_mm);
  const auto vertices = organ.vertices();
  const auto at = [&](std::uint32_t i) {
    const float* p = vertices[i].position;
    return QPointF(0.5 * kShadow_px + scale * (p[0] - centre_mm.x() + kShadowRight * radius_mm),
                   0.5 * kShadow_px - scale * (p[1] - centre_mm.y() - kShadowDown * radius_mm));
  };
  for (const TriangleMesh::Triangle& triangle : organ.triangles()) {
    const std::array<QPointF, 3> corners{at(triangle[0]), at(triangle[1]), at(triangle[2])};
    painter.drawPolygon(corners.data(), 3);
  }
  painter.end();
  return softened(shade)
      .scaled(kSide_px, kSide_px, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
      .convertToFormat(QImage::Format_Grayscale8);
}

void darken(QImage& picture, const QImage& shade) {
  for (int y = 0; y < picture.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
    const uchar* by = shade.constScanLine(y);
    for (int x = 0; x < picture.width(); ++x) {
      const double light = 1.0 - kShadowDepth * by[x] / 255.0;
      line[x] = qRgb(static_cast<int>(light * qRed(line[x])), static_cast<int>(light * qGreen(line[x])),
                     static_cast<int>(light * qBlue(line[x])));
    }
  }
}

}  // namespace

Surroundings surroundingsOf(std::string_view sceneId) {
  if (sceneId == "stomach" || sceneId.starts_with("gastric")) {
    return Surroundings::kStomach;
  }
  if (sceneId == "intestine" || sceneId == "small-bowel-loop" || sceneId == "sigmoid" ||
      sceneId == "midgut") {
    return Surroundings::kIntestine;
  }
  return Surroundings::kDrape;
}

QImage paintSurroundings(Surroundings kind, const Theme& theme, const OrganSurface& organ,
                         const QVector3D& centre_mm, float radius_mm) {
  QImage picture = unevenGround(kind, theme).convertToFormat(QImage::Format_RGB32);
  if (!onDrape(kind)) {
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(0.5 * kSide_px, 0.5 * kSide_px);
    const double scale = 0.5 * kSide_px / kSurroundingsReach;
    painter.scale(scale, -scale);
    drawOutlines(painter, kind, theme);
    drawRim(painter, theme);
  }
  if (radius_mm > 0.0F) {
    darken(picture, shadowOf(organ, centre_mm, radius_mm));
  }
  return picture;
}

void SurroundingsTexture::setPicture(const QImage& picture) {
  const QImage turned = picture.convertToFormat(QImage::Format_RGBA8888).mirrored();
  setSize(turned.size());
  setFormat(RGBA8);
  setHasTransparency(false);
  setTextureData(QByteArray(reinterpret_cast<const char*>(turned.constBits()), turned.sizeInBytes()));
}

}  // namespace torsio::gui
