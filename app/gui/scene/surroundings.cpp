// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/surroundings.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>
#include <QPointF>

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

/// Colours of a body in the half-dark.
struct Tone {
  QColor rim;
  QColor body;
  QColor gleam;
};

Tone toneOf(const Theme& theme, int hue) {
  // Little colour: only the organ to be treated may look like living tissue.
  const bool dark = theme.kind == ThemeKind::kDark;
  const auto tone = [&](int saturation, int value) { return QColor::fromHsv(hue, saturation, value); };
  return dark ? Tone{tone(38, 36), tone(40, 62), tone(32, 86)}
              : Tone{tone(24, 152), tone(20, 196), tone(11, 226)};
}

/// Draws a hollow organ along a line: rim, body, and a highlight from the lamp.
void drawTube(QPainter& painter, const QPainterPath& line, double width, const Tone& tone) {
  painter.setBrush(Qt::NoBrush);
  const auto stroke = [&](const QColor& colour, double wide, const QPointF& shift) {
    painter.setPen(QPen(colour, wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(line.translated(shift));
  };
  stroke(tone.rim, width, {});
  stroke(tone.body, 0.88 * width, {});
  QColor gleam = tone.gleam;
  constexpr int kSteps = 5;  // narrower and brighter towards the middle, for soft light
  for (int step = 1; step <= kSteps; ++step) {
    gleam.setAlpha(34);
    stroke(gleam, width * (0.66 - 0.11 * step), {-0.10 * width, 0.12 * width});
  }
}

void drawBody(QPainter& painter, const QPainterPath& outline, const Tone& tone) {
  const QRectF box = outline.boundingRect();
  QLinearGradient light(box.bottomLeft(), box.topRight());  // y up: from the upper left
  light.setColorAt(0.0, tone.gleam);
  light.setColorAt(0.45, tone.body);
  light.setColorAt(1.0, tone.rim);
  painter.setBrush(light);
  painter.setPen(QPen(tone.rim, 0.025, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(outline);
}

/// Draws colon along a line, pouch by pouch.
void drawColon(QPainter& painter, const QPainterPath& line, double width, const Tone& tone) {
  drawTube(painter, line, width, tone);
  constexpr double kPouch = 0.24;
  const double length = line.length();
  const int pouches = static_cast<int>(length / kPouch);
  QColor crease = tone.rim;
  crease.setAlpha(150);
  painter.setPen(QPen(crease, 0.022, Qt::SolidLine, Qt::RoundCap));
  for (int k = 1; k < pouches; ++k) {
    const double share = line.percentAtLength(length * k / pouches);
    const QPointF at = line.pointAtPercent(share);
    const double way = line.angleAtPercent(share) * 3.14159265358979 / 180.0;  // y down
    const QPointF across(0.42 * width * std::sin(way), 0.42 * width * std::cos(way));
    const QPointF along(0.05 * std::cos(way), -0.05 * std::sin(way));
    QPainterPath fold(at + across);
    fold.quadTo(at + along, at - across * 0.25);
    painter.drawPath(fold);
  }
}

/// Draws packed small bowel: meandering rows, the nearer over the farther ones.
void drawBowel(QPainter& painter, double left, double right, double top, double bottom, const Tone& tone) {
  constexpr double kRow = 0.36;
  constexpr double kWidth = 0.40;
  const int rows = std::max(1, static_cast<int>(std::lround((top - bottom) / kRow)));
  for (int row = 0; row < rows; ++row) {
    const double y = top - kRow * row;
    const double phase = 1.7 * row + 0.6 * (row % 3);
    QPainterPath line(QPointF(left, y));
    constexpr int kPieces = 60;
    for (int k = 1; k <= kPieces; ++k) {
      const double x = left + (right - left) * k / kPieces;
      line.lineTo(x, y + 0.17 * std::sin(3.3 * x + phase) + 0.09 * std::sin(7.1 * x - 2.0 * phase));
    }
    drawTube(painter, line, kWidth, tone);
  }
}

/// The neighbours that a stomach's mesh includes.
struct EndsOfStomach {
  bool own = false;             ///< with a stub of the oesophagus and the bulb of the duodenum
  bool pylorusInPlace = false;  ///< false: the antrum is turned away
};

/// Draws what a stomach is attached to: the oesophagus, from below the liver to the cardia, and the duodenum,
/// from the pylorus up to the gallbladder and behind the colon. Parts of the stomach's own mesh are not drawn
/// again. If the antrum is turned away, there is no open end in its place: the duodenum then comes from
/// behind the gallbladder.
void drawEndsOfStomach(QPainter& painter, const Theme& theme, const EndsOfStomach& ends) {
  const Tone tone = toneOf(theme, 8);
  QPainterPath duodenum(QPointF(-1.04, -0.14));
  if (ends.pylorusInPlace) {
    duodenum = QPainterPath(QPointF(-0.58, -0.46));
    duodenum.cubicTo(QPointF(-0.68, -0.18), QPointF(-0.88, -0.10), QPointF(-1.04, -0.14));
  }
  duodenum.cubicTo(-1.18, -0.40, -1.18, -1.15, -0.70, -1.25);
  drawTube(painter, duodenum, 0.25, tone);
  QPainterPath oesophagus(QPointF(-0.24, 1.45));
  if (ends.own) {
    oesophagus.lineTo(-0.236, 0.93);
  } else {
    oesophagus.cubicTo(-0.24, 1.00, -0.18, 0.62, 0.10, 0.36);
  }
  drawTube(painter, oesophagus, ends.own ? 0.16 : 0.19, tone);
}

void drawUpperAbdomen(QPainter& painter, const Theme& theme, const EndsOfStomach& ends) {
  QPainterPath spleen(QPointF(1.25, 1.30));
  spleen.cubicTo(1.95, 1.45, 2.1, 0.55, 1.62, -0.05);
  spleen.cubicTo(1.32, 0.2, 1.2, 0.8, 1.25, 1.30);
  drawBody(painter, spleen, toneOf(theme, 320));
  drawEndsOfStomach(painter, theme, ends);
  QPainterPath colon(QPointF(-2.0, -0.75));
  colon.cubicTo(-1.2, -1.45, 0.9, -1.5, 1.9, -0.55);
  drawColon(painter, colon, 0.46, toneOf(theme, 20));
  QPainterPath liver(QPointF(-2.2, -0.35));
  liver.cubicTo(-2.3, 1.7, -0.9, 1.95, 0.72, 1.42);
  liver.cubicTo(0.2, 0.98, -0.62, 0.98, -0.98, 0.42);
  liver.cubicTo(-1.25, -0.12, -1.7, -0.55, -2.2, -0.35);
  drawBody(painter, liver, toneOf(theme, 350));
  QPainterPath gallbladder(QPointF(-1.22, 0.10));
  gallbladder.cubicTo(-1.1, -0.30, -0.86, -0.34, -0.84, -0.06);
  gallbladder.cubicTo(-0.84, 0.16, -1.04, 0.30, -1.22, 0.10);
  drawBody(painter, gallbladder, toneOf(theme, 95));
}

void drawPelvis(QPainter& painter, const Theme& theme) {
  drawBowel(painter, -2.0, 1.0, 1.30, 0.55, toneOf(theme, 350));
  QPainterPath descending(QPointF(1.42, 1.75));
  descending.cubicTo(1.62, 0.9, 1.52, 0.1, 1.35, -0.35);
  descending.cubicTo(1.22, -0.68, 0.70, -0.72, kDescendingEnd.x(), kDescendingEnd.y());
  drawColon(painter, descending, 0.42, toneOf(theme, 20));
  QPainterPath rectum(kRectumEnd);
  rectum.cubicTo(-0.30, -1.05, 0.05, -1.15, 0.0, -1.75);
  drawColon(painter, rectum, 0.46, toneOf(theme, 20));
  QPainterPath bladder(QPointF(-1.25, -1.70));
  bladder.cubicTo(-1.35, -0.95, -0.42, -0.98, -0.36, -1.70);
  bladder.closeSubpath();
  drawBody(painter, bladder, toneOf(theme, 40));
}

/// Draws the bowel on both sides of a loop.
void drawLimbsOfLoop(QPainter& painter, const Theme& theme) {
  const Tone tone = toneOf(theme, 350);
  for (const QPointF& foot : {kLoopFirstFoot, kLoopSecondFoot}) {
    const double out = foot.x() > 0.0 ? 1.0 : -1.0;
    QPainterPath limb(foot);
    limb.cubicTo(foot + QPointF(0.16 * out, -0.26), foot + QPointF(0.14 * out, -0.62),
                 foot + QPointF(-0.14 * out, -0.74));
    limb.cubicTo(foot + QPointF(-0.40 * out, -0.86), foot + QPointF(-0.62 * out, -0.72),
                 foot + QPointF(-0.60 * out, -1.05));
    drawTube(painter, limb, 0.29, tone);
  }
}

void drawLimbsOfClosedLoop(QPainter& painter, const Theme& theme) {
  for (const QPointF& foot : {kClosedFirstFoot, kClosedSecondFoot}) {
    const double out = foot.x() > 0.0 ? 1.0 : -1.0;
    QPainterPath limb(foot + QPointF(0.0, 0.10));
    limb.cubicTo(foot + QPointF(0.0, -0.22), foot + QPointF(0.20 * out, -0.46),
                 foot + QPointF(0.55 * out, -0.34));
    limb.cubicTo(foot + QPointF(0.85 * out, -0.24), foot + QPointF(0.90 * out, 0.16),
                 foot + QPointF(1.25 * out, 0.10));
    drawTube(painter, limb, 0.28, toneOf(theme, 350));
  }
}

/// Draws the fold of peritoneum that the stalk comes down from, and the duodenum, which goes on into the
/// jejunal limb.
void drawRootOfMidgut(QPainter& painter, const Theme& theme) {
  QPainterPath root(QPointF(-0.45, 0.78));
  root.cubicTo(-0.25, 1.02, 0.45, 1.02, 0.62, 0.74);
  root.cubicTo(0.48, 0.46, 0.30, 0.36, kStalkRoot.x(), kStalkRoot.y() - 0.10);
  root.cubicTo(-0.05, 0.42, -0.32, 0.52, -0.45, 0.78);
  drawBody(painter, root, toneOf(theme, 20));
  QPainterPath duodenum(kLimbEnd + QPointF(0.0, -0.05));
  duodenum.cubicTo(kLimbEnd + QPointF(-0.02, 0.20), QPointF(-0.30, 0.92), QPointF(-0.62, 0.86));
  duodenum.cubicTo(-0.95, 0.80, -1.05, 1.00, -1.20, 1.12);
  drawTube(painter, duodenum, 0.17, toneOf(theme, 8));
}

}  // namespace

QColor neighbourColour(const Theme& theme) {
  return toneOf(theme, 8).body.darker(108);
}

Surroundings surroundingsOf(std::string_view sceneId, bool former) {
  if (sceneId == "gastric-mesentero-axial" && former) {
    return Surroundings::kBareTurnedAntrum;
  }
  if (sceneId == "stomach" || sceneId.starts_with("gastric")) {
    return former ? Surroundings::kBareStomach : Surroundings::kStomach;
  }
  if (sceneId == "sigmoid") {
    return Surroundings::kPelvis;
  }
  if (sceneId == "small-bowel-loop" && !former) {
    return Surroundings::kClosedLoop;
  }
  if (sceneId == "intestine" || sceneId == "small-bowel-loop") {
    return Surroundings::kBowelLoop;
  }
  if (sceneId == "midgut") {
    return former ? Surroundings::kIntestine : Surroundings::kMidgut;
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

void drawNeighbours(QPainter& painter, Surroundings kind, const Theme& theme) {
  switch (kind) {
    case Surroundings::kDrape:
    case Surroundings::kArm:
      return;
    case Surroundings::kStomach:
    case Surroundings::kBareStomach:
    case Surroundings::kBareTurnedAntrum:
      drawUpperAbdomen(
          painter, theme,
          {.own = kind == Surroundings::kStomach, .pylorusInPlace = kind == Surroundings::kBareStomach});
      return;
    case Surroundings::kPelvis:
      drawPelvis(painter, theme);
      return;
    case Surroundings::kIntestine:
    case Surroundings::kBowelLoop:
    case Surroundings::kClosedLoop:
    case Surroundings::kMidgut:
      break;
  }
  QPainterPath colon(QPointF(-1.50, -1.6));
  colon.cubicTo(-1.70, -0.4, -1.68, 0.7, -1.45, 1.12);
  colon.cubicTo(-0.7, 1.45, 0.7, 1.45, 1.45, 1.12);
  colon.cubicTo(1.68, 0.7, 1.70, -0.4, 1.50, -1.6);
  drawBowel(painter, -1.6, 1.6, 1.00, -1.60, toneOf(theme, 350));
  drawColon(painter, colon, 0.40, toneOf(theme, 20));
  if (kind == Surroundings::kBowelLoop) {
    drawLimbsOfLoop(painter, theme);
  } else if (kind == Surroundings::kClosedLoop) {
    drawLimbsOfClosedLoop(painter, theme);
  } else if (kind == Surroundings::kMidgut) {
    drawRootOfMidgut(painter, theme);
  }
}

}  // namespace torsio::gui
