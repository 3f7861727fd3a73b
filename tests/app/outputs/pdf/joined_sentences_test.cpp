// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/wording/joined_sentences.h"

#include <gtest/gtest.h>

namespace torsio {
namespace {

TEST(JoinedSentences, AreSeparatedBySpacesInEnglishAndNotInChinese) {
  EXPECT_EQ(joinedSentences({"Done.", "", "Go on."}), QStringLiteral("Done. Go on."));
  const QString done = QStringLiteral("\u5df2\u5b8c\u6210\u3002");
  const QString asked = QStringLiteral("\u662f\u5426\u7ee7\u7eed\uff1f");
  EXPECT_EQ(joinedSentences({done, asked, done}), done + asked + done);
  EXPECT_EQ(joinedSentences({}), QString());
}

}  // namespace
}  // namespace torsio
