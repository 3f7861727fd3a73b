// SPDX-License-Identifier: GPL-3.0-or-later
// Contents of printed report pages, read back from the file. Dates and counts: in the locale's format for
// readers, ISO 8601 and plain digits in files. The minus: U+2212 for readers, a hyphen in files. One
// explicit typeface, independent of the system's default.

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <QApplication>
#include <QChart>
#include <QFontDatabase>
#include <QFontInfo>
#include <QLineSeries>
#include <QProcess>
#include <QRegularExpression>
#include <QScatterSeries>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/outputs/charts/chart_builder.h"
#include "app/outputs/charts/typeface.h"
#include "app/outputs/pdf/pdf_report.h"
#include "app/outputs/wording/joined_sentences.h"
#include "app/outputs/wording/printed_minus.h"
#include "app/outputs/wording/printed_value.h"
#include "app/outputs/wording/wording.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "assessment/results/figure_table.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {

namespace {

/// Returns the text of the pages line by line.
std::string printedLines(const std::filesystem::path& file) {
  QProcess reader;
  reader.start(QStringLiteral("pdftotext"),
               {QStringLiteral("-layout"), QString::fromStdString(file.string()), QStringLiteral("-")});
  EXPECT_TRUE(reader.waitForFinished()) << "pdftotext of poppler-utils";
  return reader.readAllStandardOutput().toStdString();
}

TEST(PrintedReport, ListsForEachModelWhatAClassOfRatersHasNotScored) {
  const CohortInputs in = testing::aClassOfRatersIsMissing();
  ReportModel report = cohortReport(in);
  std::erase_if(report.sections, [](const ReportSection& section) {
    return section.title.str() != "Evaluation of the models";
  });
  const QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "cohort.pdf";

  writePdfReport(report, file);

  const std::string& missing = in.instrument.classes[2].name;
  std::istringstream pages(printedLines(file));
  std::map<std::string, int> lines;  // by model
  for (std::string line; std::getline(pages, line);) {
    for (const ModelRatings& model : in.ratings) {
      const bool said = line.find(missing) != std::string::npos && line.find("all 9") != std::string::npos;
      lines[model.model] += said && line.find(model.model) != std::string::npos ? 1 : 0;
    }
  }
  for (const ModelRatings& model : in.ratings) {
    EXPECT_EQ(lines[model.model], 1) << missing << ", " << model.model;
  }
}

TEST(PrintedReport, DrawsTheLineOfNormalResiduals) {
  const ReportModel report = cohortReport(testing::demonstrationCohort());
  const ReportFigure* figure = testing::figureNamed(report, "figure-qq");
  ASSERT_NE(figure, nullptr);

  const std::unique_ptr<QChart> chart = buildChart(*figure);

  std::vector<const QLineSeries*> lines;
  std::size_t dots = 0;
  for (const QAbstractSeries* series : chart->series()) {
    if (const auto* line = qobject_cast<const QLineSeries*>(series)) {
      lines.push_back(line);
    } else if (const auto* points = qobject_cast<const QScatterSeries*>(series)) {
      dots += static_cast<std::size_t>(points->count());
    }
  }
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0]->name(), QStringLiteral("as normal residuals"));
  for (const QPointF& end : lines[0]->points()) {
    EXPECT_EQ(end.x(), end.y());
  }
  EXPECT_LT(lines[0]->at(0).x(), 0.0);
  EXPECT_GT(lines[0]->at(1).x(), 0.0);
  EXPECT_EQ(dots, 30U);
  EXPECT_EQ(figureTable(*figure, 4).rows.size(), 30U);  // the line is not a value
}

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

TEST(JoinedSentences, AreSeparatedBySpacesInEnglishAndNotInChinese) {
  EXPECT_EQ(joinedSentences({"Done.", "", "Go on."}), QStringLiteral("Done. Go on."));
  const QString done = QStringLiteral("\u5df2\u5b8c\u6210\u3002");
  const QString asked = QStringLiteral("\u662f\u5426\u7ee7\u7eed\uff1f");
  EXPECT_EQ(joinedSentences({done, asked, done}), done + asked + done);
  EXPECT_EQ(joinedSentences({}), QString());
}

TEST(JoinedSentences, HaveNoBlankBetweenThemInAChineseText) {
  const Text both = Text::verbatim("%1 %2", Text::tr("No deviation from the protocol was reported."),
                                   Text::tr("No deviation from the protocol was reported."));
  const QString words = wordingIn("zh_CN")(both);
  EXPECT_EQ(words.count(u'\u3002'), 2);
  EXPECT_FALSE(words.contains(u' ')) << words.toStdString();
}

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
