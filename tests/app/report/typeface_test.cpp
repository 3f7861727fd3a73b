// SPDX-License-Identifier: GPL-3.0-or-later
// One typeface, named, whatever the machine's default is.
#include "app/report/typeface.h"

#include <QApplication>
#include <QFontDatabase>
#include <QFontInfo>
#include <gtest/gtest.h>

namespace torsio {
namespace {

TEST(Typeface, IsInstalledWithThePackagesOfTheSetup) {
  const QStringList installed = QFontDatabase::families();

  const QStringList missing = missingTypefaces(installed);

  EXPECT_TRUE(missing.isEmpty()) << missing.join(QStringLiteral(", ")).toStdString() << " (app/setup.sh)";
}

TEST(Typeface, IsThatOfTheApplicationAndOfTheReport) {
  const QFont application = QApplication::font();

  const QFont report = typeface();

  EXPECT_EQ(QFontInfo(application).family(), QLatin1String(kTypeface));
  EXPECT_EQ(QFontInfo(report).family(), QLatin1String(kTypeface));
}

TEST(Typeface, NamesEachFamilyThatAMachineLacks) {
  const QStringList onlyAnother{QStringLiteral("Noto Sans")};
  const QStringList onlyLatin{QLatin1String(kTypeface)};

  EXPECT_EQ(missingTypefaces(onlyAnother),
            QStringList({QLatin1String(kTypeface), QLatin1String(kChineseTypeface)}));
  EXPECT_EQ(missingTypefaces(onlyLatin), QStringList({QLatin1String(kChineseTypeface)}));
  EXPECT_TRUE(missingTypefaces({QLatin1String(kTypeface), QLatin1String(kChineseTypeface)}).isEmpty());
}

}  // namespace
}  // namespace torsio
