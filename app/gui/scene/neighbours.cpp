// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/neighbours.h"

#include <cmath>
#include <vector>

#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>
#include <QPointF>

#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

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
    duodenum = QPainterPath(ends.own ? kBulbEnd : QPointF(-0.58, -0.46));
    duodenum.cubicTo(ends.own ? QPointF(-0.74, -0.14) : QPointF(-0.68, -0.18), QPointF(-0.88, -0.10),
                     QPointF(-1.04, -0.14));
  }
  duodenum.cubicTo(-1.18, -0.40, -1.18, -1.15, -0.70, -1.25);
  drawTube(painter, duodenum, 0.25, tone);
  QPainterPath oesophagus(QPointF(-0.24, 1.45));
  if (ends.own) {
    oesophagus.cubicTo(QPointF(-0.24, 1.20), QPointF(-0.24, 0.88), kStubEnd);
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
  descending.cubicTo(1.22, -0.68, 0.78, -0.70, 0.42, -0.78);
  drawColon(painter, descending, 0.42, toneOf(theme, 20));
  QPainterPath rectum(QPointF(-0.30, -0.80));
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

}  // namespace

void drawNeighbours(QPainter& painter, Surroundings kind, const Theme& theme) {
  switch (kind) {
    case Surroundings::kDrape:
    case Surroundings::kArm:
      return;
    case Surroundings::kStomach:
    case Surroundings::kTurnedAntrum:
    case Surroundings::kBareStomach:
    case Surroundings::kBareTurnedAntrum:
      drawUpperAbdomen(
          painter, theme,
          {.own = kind == Surroundings::kStomach || kind == Surroundings::kTurnedAntrum,
           .pylorusInPlace = kind == Surroundings::kStomach || kind == Surroundings::kBareStomach});
      return;
    case Surroundings::kPelvis:
      drawPelvis(painter, theme);
      return;
    case Surroundings::kIntestine:
    case Surroundings::kBowelLoop:
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
  }
}

}  // namespace torsio::gui
