// SPDX-License-Identifier: GPL-3.0-or-later
// Dates and counts: in the locale's format for readers, ISO 8601 and plain digits in files.
#include "app/outputs/wording/printed_value.h"

#include <gtest/gtest.h>

#include "app/outputs/wording/wording.h"

namespace torsio {
namespace {

const Text kTrail = Text::verbatim("%1 {entry|entries} at %2, seed %3", 2202,
                                   std::string("2026-01-05 08:00 UTC"), std::string("123456"));

TEST(PrintedValue, HasMonthNamesAndGroupedDigitsForReaders) {
  EXPECT_EQ(wordingIn("en")(kTrail).toStdString(), "2,202 entries at 5 Jan 2026 08:00 UTC, seed 123456");
  EXPECT_EQ(wordingIn("zh_CN")(kTrail).toStdString(), "2,202 entries at 2026/1/5 08:00 UTC, seed 123456");
  EXPECT_EQ(englishWording(std::string("2026-01-05 08:00 UTC")).toStdString(), "5 Jan 2026 08:00 UTC");
}

TEST(PrintedValue, IsUnchangedInFiles) {
  for (const std::string& language : reportLanguages()) {
    EXPECT_EQ(wordingIn(language, Signs::kOfFiles)(kTrail).toStdString(),
              "2202 entries at 2026-01-05 08:00 UTC, seed 123456");
  }
}

TEST(PrintedValue, LeavesOtherTextsUnchanged) {
  const QLocale english(QLocale::English, QLocale::UnitedKingdom);
  for (const char* other : {"2026-01-05", "run 2026-01-05 08:00 UTC", "2026-13-05 08:00 UTC", ""}) {
    EXPECT_EQ(printedTime(QString::fromUtf8(other), english), QString::fromUtf8(other));
  }
  for (const char* other : {"0", "007", "12.5", "-1808", "7F", "1234567890123456789"}) {
    EXPECT_EQ(printedCount(QString::fromUtf8(other), english), QString::fromUtf8(other));
  }
  EXPECT_EQ(printedCount(QStringLiteral("1"), english), QStringLiteral("1"));
}

}  // namespace
}  // namespace torsio
