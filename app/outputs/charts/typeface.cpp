// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/typeface.h"

#include <cstdio>

#include <QApplication>
#include <QFontDatabase>

namespace torsio {

QFont typeface() {
  QFont font;
  // Listed explicitly: a system's fallback may choose Japanese forms of the characters. The last two are the
  // Chinese companions on Windows and macOS.
  font.setFamilies({QLatin1String(kTypeface), QLatin1String(kFallbackTypeface),
                    QLatin1String(kChineseTypeface), QStringLiteral("Microsoft YaHei"),
                    QStringLiteral("PingFang SC")});
  return font;
}

QFont printedTypeface() {
  constexpr double kApart_px =
      1.0 / 64.0;  // the smallest spacing that counts: spaced letters have no ligatures
  QFont font = typeface();
  font.setLetterSpacing(QFont::AbsoluteSpacing, kApart_px);
  return font;
}

QStringList missingTypefaces(const QStringList& installed) {
  QStringList missing;
  for (const char* family : {kTypeface, kFallbackTypeface, kChineseTypeface}) {
    if (!installed.contains(QLatin1String(family))) {
      missing << QLatin1String(family);
    }
  }
  return missing;
}

void useTypeface(QApplication& application) {
  for (const QString& family : missingTypefaces(QFontDatabase::families())) {
    std::fprintf(stderr, "torsio: the typeface '%s' is not installed; another takes its place\n",
                 qPrintable(family));
  }
  application.setFont(typeface());
}

}  // namespace torsio
