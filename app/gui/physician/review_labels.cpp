// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/review_labels.h"

#include <cmath>

#include <QCoreApplication>
#include <QLocale>

#include "app/gui/widgets/value_text.h"

namespace torsio::gui {

QString pointsText(double points) {
  const bool whole = std::abs(points - std::round(points)) < 1e-9;
  const bool tenths = std::abs(points * 10.0 - std::round(points * 10.0)) < 1e-9;
  return numberText(points, whole ? 0 : tenths ? 1 : 2);
}

QString scoreText(std::int64_t score_steps, const ScoreScale& scale) {
  return pointsText(pointsFromSteps(score_steps, scale));
}

QString signedText(double points) {
  const double rounded = std::round(points * 10.0) / 10.0;
  const QString figure = numberText(rounded, 1);
  return rounded > 0.0 ? QLatin1Char('+') + figure : figure;
}

namespace {

QString key(const char* text) {
  return QCoreApplication::translate("torsio::gui::ReviewKeys", text);
}

}  // namespace

std::vector<std::pair<QString, QString>> sheetKeys() {
  return {
      {key(QT_TRANSLATE_NOOP("torsio::gui::ReviewKeys", "Give the selected row a mark; 1 and then 0 is ten")),
       QStringLiteral("0 \u2026 9")},
      {key(QT_TRANSLATE_NOOP("torsio::gui::ReviewKeys",
                             "Half a point less or more; with Shift the finest step")),
       QStringLiteral("\u2190 \u2192")},
      {key(QT_TRANSLATE_NOOP("torsio::gui::ReviewKeys", "Another row")),
       QStringLiteral("\u2191 \u2193, Tab")},
      {key(QT_TRANSLATE_NOOP("torsio::gui::ReviewKeys", "Clear the mark")), QStringLiteral("Backspace")},
      {key(QT_TRANSLATE_NOOP("torsio::gui::ReviewKeys", "Undo, redo")), QStringLiteral("Ctrl+Z, Ctrl+Y")},
      {key(QT_TRANSLATE_NOOP("torsio::gui::ReviewKeys", "Submit; press again to seal")),
       QStringLiteral("Ctrl+Enter")}};
}

std::vector<std::pair<QString, QString>> replayKeys() {
  return {{key(QT_TRANSLATE_NOOP("torsio::gui::ReviewKeys", "Play, pause")), QStringLiteral("Space")},
          {key(QT_TRANSLATE_NOOP("torsio::gui::ReviewKeys", "Five seconds back, pause, play")),
           QStringLiteral("J, K, L")},
          {key(QT_TRANSLATE_NOOP("torsio::gui::ReviewKeys", "One picture back, one picture on")),
           QStringLiteral(",  .")},
          {key(QT_TRANSLATE_NOOP("torsio::gui::ReviewKeys", "Beginning, end of the recording")),
           QStringLiteral("Home, End")}};
}

}  // namespace torsio::gui
