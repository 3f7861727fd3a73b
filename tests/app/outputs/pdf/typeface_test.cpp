// SPDX-License-Identifier: GPL-3.0-or-later
// One explicit typeface, independent of the system's default.
#include "app/outputs/charts/typeface.h"

#include <QApplication>
#include <QFontDatabase>
#include <QFontInfo>
#include <gtest/gtest.h>

namespace torsio {
namespace {

TEST(Typeface, IsInstalledWithTheSetupPackages) {
  const QStringList installed = QFontDatabase::families();

  const QStringList missing = missingTypefaces(installed);

  EXPECT_TRUE(missing.isEmpty()) << missing.join(QStringLiteral(", ")).toStdString() << " (app/setup.sh)";
}

TEST(Typeface, IsUsedByTheApplicationAndTheReport) {
  const QFont application = QApplication::font();

  const QFont report = typeface();

  EXPECT_EQ(QFontInfo(application).family(), QLatin1String(kTypeface));
  EXPECT_EQ(QFontInfo(report).family(), QLatin1String(kTypeface));
}

TEST(Typeface, ListsEachMissingFamily) {
  const QString latin = QLatin1String(kTypeface);
  const QString fallback = QLatin1String(kFallbackTypeface);
  const QString chinese = QLatin1String(kChineseTypeface);

  EXPECT_EQ(missingTypefaces({QStringLiteral("Comic Sans MS")}), QStringList({latin, fallback, chinese}));
  EXPECT_EQ(missingTypefaces({latin}), QStringList({fallback, chinese}));
  EXPECT_TRUE(missingTypefaces({chinese, fallback, latin}).isEmpty());
}

TEST(Typeface, FallsBackInTheDocumentedOrder) {
  EXPECT_EQ(typeface().families().mid(0, 3),
            QStringList({QStringLiteral("Noto Sans"), QStringLiteral("DejaVu Sans"),
                         QStringLiteral("Noto Sans CJK SC")}));
}

}  // namespace
}  // namespace torsio
