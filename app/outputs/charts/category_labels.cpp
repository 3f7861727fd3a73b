// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/category_labels.h"

#include <algorithm>

#include <QFontMetricsF>

#include "app/outputs/charts/text_fit.h"
#include "app/outputs/charts/typeface.h"

namespace torsio {

namespace {

constexpr double kAir_px = 8.0;  // left and right of a label, as in Qt
constexpr int kSmallest_px = 8;
constexpr int kReadable_px = 10;
constexpr qsizetype kMaxLines = 3;
constexpr qsizetype kTogether = 6;  // Chinese characters kept on one line

/// Joins lines into HTML for an axis.
QString htmlOf(const QStringList& lines) {
  QStringList escaped;
  for (const QString& line : lines) {
    escaped << line.toHtmlEscaped();
  }
  return escaped.join(QStringLiteral("<br>"));
}

}  // namespace

CategoryLabels categoryLabels(const QStringList& names, const ChartStyle& look) {
  // Qt divides the axis by its ticks: one more than there are categories.
  const double share_px = look.axis_px / static_cast<double>(names.size() + 1) - kAir_px;
  CategoryLabels labels{{}, printedTypeface()};
  labels.font.setPixelSize(look.label_px - 1);
  while (true) {
    const QFontMetricsF metrics(labels.font);
    bool fits = true;
    labels.html.clear();
    for (const QString& name : names) {
      const QStringList lines = wrappedLines(name, share_px, metrics);
      labels.html << htmlOf(lines);
      fits = fits && lines.size() <= kMaxLines && widestPart(name, metrics, kTogether) <= share_px;
    }
    if (fits || labels.font.stretch() == QFont::SemiCondensed) {
      return labels;
    }
    if (labels.font.pixelSize() > kSmallest_px) {
      labels.font.setPixelSize(labels.font.pixelSize() - 1);
    } else {
      labels.font.setStretch(QFont::SemiCondensed);
    }
  }
}

bool labelsAreReadable(const QStringList& names, const ChartStyle& look) {
  return categoryLabels(names, look).font.pixelSize() >= std::min(kReadable_px, look.label_px - 1);
}

}  // namespace torsio
