// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/text_fit.h"

#include <algorithm>

#include <QTextBoundaryFinder>

namespace torsio {

namespace {

bool endsInChinese(const QString& part) {
  const QString word = part.trimmed();
  return !word.isEmpty() && word.back().script() == QChar::Script_Han;
}

}  // namespace

QStringList breakableParts(const QString& text) {
  QStringList parts;
  QTextBoundaryFinder finder(QTextBoundaryFinder::Line, text);
  qsizetype begin = 0;
  for (qsizetype end = finder.toNextBoundary(); end > 0; end = finder.toNextBoundary()) {
    parts << text.mid(begin, end - begin);
    begin = end;
  }
  return parts;
}

double widestPart(const QString& text, const QFontMetricsF& metrics, qsizetype together) {
  double widest = 0.0;
  QString run;
  qsizetype characters = 0;
  for (const QString& part : breakableParts(text)) {
    const bool goesOn = characters > 0 && characters < together && endsInChinese(part);
    run = goesOn ? run + part : part;
    characters = endsInChinese(part) ? (goesOn ? characters + 1 : 1) : 0;
    widest = std::max(widest, metrics.horizontalAdvance(run.trimmed()));
  }
  return widest;
}

QStringList wrappedLines(const QString& text, double width, const QFontMetricsF& metrics) {
  QStringList lines;
  QString line;
  for (const QString& part : breakableParts(text)) {
    if (!line.isEmpty() && metrics.horizontalAdvance((line + part).trimmed()) > width) {
      lines << line.trimmed();
      line.clear();
    }
    line += part;
  }
  if (!line.trimmed().isEmpty()) {
    lines << line.trimmed();
  }
  return lines;
}

}  // namespace torsio
