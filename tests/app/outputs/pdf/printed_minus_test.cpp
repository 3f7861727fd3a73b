// SPDX-License-Identifier: GPL-3.0-or-later
// The minus: U+2212 for readers, a hyphen in files.
#include "app/outputs/wording/printed_minus.h"

#include <array>
#include <string>
#include <utility>

#include <QRegularExpression>
#include <gtest/gtest.h>

#include "app/outputs/wording/wording.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "tests/support/cohort_rows.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

TEST(PrintedMinus, ReplacesTheHyphenOfNumbersButNotOfWordsDatesAndCodes) {
  using Pair = std::pair<const char16_t*, const char16_t*>;
  constexpr std::array kPairs{Pair{u"-1.4 points [-1.7; -1.2]", u"\u22121.4 points [\u22121.7; \u22121.2]"},
                              Pair{u"(-.5)", u"(\u2212.5)"},
                              Pair{u"\u5dee\u4e3a-1.4", u"\u5dee\u4e3a\u22121.4"},
                              Pair{u"divisor n - 1", u"divisor n\u00a0\u2212\u00a01"},
                              Pair{u"2026-11-27, T-20, 0-20 min, R-12-3ffa, 1e-05, two-sided", nullptr},
                              Pair{u"Autumn - 2 groups", nullptr},
                              Pair{u"C:\\x\\-1.csv and a/-1.csv", nullptr},
                              Pair{u"", nullptr}};
  for (const auto& [plain, shown] : kPairs) {
    EXPECT_EQ(printedMinus(QString::fromUtf16(plain)).toStdString(),
              QString::fromUtf16(shown == nullptr ? plain : shown).toStdString());
  }
}

TEST(PrintedMinus, IsConvertedBackToTheHyphenOfFiles) {
  EXPECT_EQ(plainMinus(printedMinus(QStringLiteral("-1.4 [-1.7; -1.2]"))),
            QStringLiteral("-1.4 [-1.7; -1.2]"));
}

TEST(PrintedMinus, ReplacesTheHyphenBetweenArgumentsOfAPatternButNotInFreeText) {
  const Text pair = Text::verbatim("%1 - %2", std::string("Group 1"), std::string("North - South"));

  EXPECT_EQ(englishWording(pair).toStdString(), "Group 1 \u2212 North - South");
  EXPECT_EQ(wordingIn("en")(pair), englishWording(pair));
  EXPECT_EQ(pair.str(), "Group 1 - North - South");
}

TEST(PrintedMinus, IsNotWrittenIntoFiles) {
  const Text text = Text::verbatim("%1 - %2, -1.5", std::string("A"), std::string("-2"));
  for (const std::string& language : reportLanguages()) {
    EXPECT_EQ(wordingIn(language, Signs::kOfFiles)(text).toStdString(), "A - -2, -1.5");
  }
}

/// No cell or note of the report has a hyphen as minus, and the table of numbers has nothing else.
TEST(PrintedMinus, IsEverywhereInTheReportAndNowhereInItsTableOfNumbers) {
  const CohortInputs in = testing::demonstrationCohort();
  static const QRegularExpression kHyphen(QStringLiteral("(^|[\\s(\\[;,:])-[0-9]| - [0-9]|^Group [0-9] - "));
  int minuses = 0;
  for (const std::string& language : reportLanguages()) {
    const Wording say = wordingIn(language);
    const auto look = [&](const Text& text) {
      const QString said = say(text);
      EXPECT_FALSE(kHyphen.match(said).hasMatch()) << said.toStdString();
      minuses += static_cast<int>(said.count(QChar(0x2212)));
    };
    for (const ReportSection& section : cohortReport(in).sections) {
      for (const Text& paragraph : section.paragraphs) {
        look(paragraph);
      }
      for (const ReportFigure& figure : section.figures) {
        for (const Text& category : figure.categories) {
          look(category);
        }
      }
      for (const ReportTable& table : section.tables) {
        for (const std::vector<ReportCell>& row : table.rows) {
          for (const Text& cell : row) {
            look(cell);
          }
        }
      }
    }
  }
  EXPECT_GT(minuses, 20);

  const std::string numbers = cohortCsvText(cohortCsvRows(in));
  EXPECT_NE(numbers.find("Group 1 - Group 2"), std::string::npos);
  EXPECT_NE(numbers.find(",-"), std::string::npos);
  EXPECT_EQ(numbers.find("\u2212"), std::string::npos);
}

}  // namespace
}  // namespace torsio
