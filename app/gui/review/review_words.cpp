// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/review/review_words.h"

#include <cmath>

#include <QDateTime>
#include <QLocale>

namespace torsio::gui {

QString clockTime(std::int64_t time_us) {
  const std::int64_t seconds = time_us / 1'000'000;
  return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

QString pointsText(double points) {
  QLocale locale;
  const bool whole = std::abs(points - std::round(points)) < 1e-9;
  const bool tenths = std::abs(points * 10.0 - std::round(points * 10.0)) < 1e-9;
  return locale.toString(points, 'f', whole ? 0 : tenths ? 1 : 2);
}

QString scoreText(std::int64_t score_steps, const ScoreScale& scale) {
  return pointsText(pointsFromSteps(score_steps, scale));
}

QString signedText(double points) {
  const double rounded = std::round(points * 10.0) / 10.0;
  const QString figure = QLocale().toString(std::abs(rounded), 'f', 1);
  if (rounded > 0.0) return QStringLiteral("+%1").arg(figure);
  return rounded < 0.0 ? QStringLiteral("\u2212%1").arg(figure) : figure;
}

QString dayText(std::int64_t utc_us) {
  return QLocale().toString(QDateTime::fromMSecsSinceEpoch(utc_us / 1000).date(), QLocale::ShortFormat);
}

}  // namespace torsio::gui
