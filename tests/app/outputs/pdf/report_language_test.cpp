// SPDX-License-Identifier: GPL-3.0-or-later
// The report in Chinese: no English is left, and the numbers are those of the English report.
#include <algorithm>
#include <filesystem>
#include <functional>

#include <QDate>
#include <QLocale>
#include <QProcess>
#include <QRegularExpression>
#include <QStringList>
#include <gtest/gtest.h>

#include "app/outputs/pdf/pdf_report.h"
#include "app/outputs/wording/printed_minus.h"
#include "app/outputs/wording/wording.h"
#include "assessment/results/figure_table.h"
#include "assessment/results/provenance_line.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

/// Everything that a report can contain: frozen data, deviations, doses, twists of a recording.
CohortInputs everything() {
  CohortInputs in = testing::demonstrationCohort();
  in.title = Text::verbatim("Twist training: cohort report");
  in.centre = "Demonstration centre (simulated)";
  in.freeze = CohortFreeze{"final", std::string(64, 'b'), 1'767'600'000'000'000, "admin", false};
  in.allocation.method = Text::verbatim("complete permutation");
  in.allocation.design = {{Text::verbatim("Block sizes"), Text::verbatim("3, 6")}};
  in.deviations = {{1'767'600'000'000'000, "x101", "device failed", ""}};
  in.doses = {{"x101", 38.5, 0.0, 5.0}};
  in.notAllocated = 2;
  in.notAssessable = 1;
  in.trials[0].attempts = {{8.0, false}, {3.0, true}, {2.0, true}};
  in.trials[0].refusedSamples = 4;
  in.trials[0].interrupted = true;
  return in;
}

using Say = std::function<void(const std::string& where, const Text& text)>;

void sayTable(const ReportTable& table, const Say& say) {
  say(table.id, table.title);
  for (const Text& column : table.columns) {
    say(table.id, column);
  }
  for (const std::vector<ReportCell>& row : table.rows) {
    for (const Text& cell : row) {
      say(table.id, cell);
    }
  }
  for (const Text& note : table.notes) {
    say(table.id, note);
  }
  say(table.id, provenanceLine(table.provenance));
}

void sayFigure(const ReportFigure& figure, const Say& say) {
  for (const Text* text : {&figure.title, &figure.xLabel, &figure.yLabel}) {
    say(figure.id, *text);
  }
  for (const Text& category : figure.categories) {
    say(figure.id, category);
  }
  for (const FigureSeries& series : figure.series) {
    say(figure.id, series.name);
  }
  for (const FigureReference& reference : figure.references) {
    say(figure.id, reference.label);
  }
  for (const Text& note : figure.notes) {
    say(figure.id, note);
  }
  sayTable(figureTable(figure, 4), say);
}

/// Visits every text of the report, in order.
void sayAll(const ReportModel& model, const Say& say) {
  say("cover", model.title);
  say("cover", model.subtitle);
  for (const auto& [label, value] : model.facts) {
    say("cover", label);
    say("cover", value);
  }
  for (const ReportSection& section : model.sections) {
    say("section", section.title);
    for (const Text& paragraph : section.paragraphs) {
      say("section", paragraph);
    }
    for (const ReportFigure& figure : section.figures) {
      sayFigure(figure, say);
    }
    for (const ReportTable& table : section.tables) {
      sayTable(table, say);
    }
  }
}

/// Removes what is not translated: names of methods and models, codes, units, symbols, hashes, versions.
QString withoutKeptWords(QString text) {
  static const QRegularExpression kKept(QStringLiteral(
      "Arm sheet|Pace|Aim|far too slow|quick and steady|criterion|"  // a scoring sheet is in the centre's
                                                                     // language
      "Bland-Altman|Bell-McCaffrey|Shapiro-Wilk|Bonferroni|Student|Biau|Porcher|Shrout-Fleiss|Shrout|Fleiss|"
      "Krippendorff|"
      "Cohen|CONSORT|GRRAS|Cheng|"
      "Hedges|Kruskal-Wallis|Dunn|Holm|"
      "Mann-Whitney|Friedman|Kendall|Rasch|Greenhouse-Geisser|Hyndman-Fan|Fisher-Yates|Torsio|torsio replay "
      "RUN "
      "--verify|LC-CUSUM|CUSUM|ICC|SEM|FEM|MSM|CSV|III|UTC|min|saint_venant|final|admin|mt19937_64|"
      "(evaluation|training|allocation)-\\d|R-[0-9]+-[0-9a-f]{8}|\\b[0-9a-f]{16,}\\b"));
  return text.remove(kKept);
}

/// Converts dates and counts to the format of files: readers see "5 Jan 2026" and "30,000".
QString asInFiles(QString text) {
  static const QRegularExpression kGroup(QStringLiteral("(?<=[0-9]),(?=[0-9]{3}(?![0-9]))"));
  static const QRegularExpression kDay(
      QStringLiteral("\\b[0-9]{1,2} [A-Z][a-z]{2} [0-9]{4}\\b|\\b[0-9]{4}/[0-9]{1,2}/[0-9]{1,2}\\b"));
  text.remove(kGroup);
  for (QRegularExpressionMatch day = kDay.match(text); day.hasMatch(); day = kDay.match(text)) {
    const QString shown = day.captured();
    const QDate date = QLocale::c().toDate(
        shown, shown.contains(u'/') ? QStringLiteral("yyyy/M/d") : QStringLiteral("d MMM yyyy"));
    text.replace(day.capturedStart(), shown.size(), date.toString(Qt::ISODate));
  }
  return text;
}

QStringList numbersOf(const QString& text) {
  static const QRegularExpression kNumber(QStringLiteral("[0-9]+([.][0-9]+)?"));
  QStringList numbers;
  // The exponent is a digit in English ("s2") and a symbol in Chinese.
  QString plain = text;
  plain.replace(QStringLiteral("s2"), QStringLiteral("s"));
  for (auto match = kNumber.globalMatch(plain); match.hasNext();) {
    numbers << match.next().captured();
  }
  numbers.sort();
  return numbers;
}

TEST(ReportLanguage, LeavesNoEnglishWordInTheChineseReport) {
  static const QRegularExpression kWord(QStringLiteral("[A-Za-z]{3,}"));
  const Wording chinese = wordingIn("zh_CN");
  int said = 0;

  sayAll(cohortReport(everything()), [&](const std::string& where, const Text& text) {
    ++said;
    const QString words = chinese(text);
    EXPECT_FALSE(kWord.match(withoutKeptWords(words)).hasMatch())
        << where << ": " << words.toStdString() << "\n  of: " << text.str();
  });

  EXPECT_GT(said, 1'000);
}

TEST(ReportLanguage, GivesEveryFigureAndTableAChineseTitle) {
  static const QRegularExpression kHan(QStringLiteral("\\p{Han}"));
  const Wording chinese = wordingIn("zh_CN");

  for (const ReportSection& section : cohortReport(everything()).sections) {
    EXPECT_TRUE(kHan.match(chinese(section.title)).hasMatch()) << section.title;
    for (const ReportFigure& figure : section.figures) {
      EXPECT_TRUE(kHan.match(chinese(figure.title)).hasMatch()) << figure.title;
    }
    for (const ReportTable& table : section.tables) {
      EXPECT_TRUE(kHan.match(chinese(table.title)).hasMatch()) << table.title;
    }
  }
}

TEST(ReportLanguage, HasTheSameNumbersInBothLanguages) {
  const Wording english = wordingIn("en");
  const Wording chinese = wordingIn("zh_CN");

  sayAll(cohortReport(everything()), [&](const std::string& where, const Text& text) {
    const QString printed = asInFiles(plainMinus(english(text)).replace(QChar(0xA0), u' '));
    const QString written = asInFiles(QString::fromStdString(text.str()).replace(QChar(0xA0), u' '));
    EXPECT_EQ(printed.toStdString(), written.toStdString());
    EXPECT_EQ(numbersOf(asInFiles(chinese(text))), numbersOf(printed)) << where << ": " << text.str();
  });
}

TEST(ReportLanguage, WritesAChinesePdfWithEmbeddedFonts) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / "torsio-report-language" / "report.pdf";
  std::filesystem::remove_all(file.parent_path());
  std::filesystem::create_directories(file.parent_path());

  writePdfReport(cohortReport(everything()), file, wordingIn("zh_CN"));

  const std::string pdf = readFile(file);
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_NE(pdf.find("NotoSansCJK"), std::string::npos) << "fonts-noto-cjk is missing (app/setup.sh)";
  EXPECT_EQ(pdf.find("/Subtype /Image"), std::string::npos);
}

/// Returns a text without blanks and with plain minus signs, as a page may break its lines anywhere.
QString solid(QString text) {
  return plainMinus(text.remove(QRegularExpression(QStringLiteral("\\s"))))
      .normalized(QString::NormalizationForm_KC);
}

QString pageText(const std::filesystem::path& file, int page) {
  QProcess reader;
  reader.start(QStringLiteral("pdftotext"),
               {QStringLiteral("-f"), QString::number(page), QStringLiteral("-l"), QString::number(page),
                QString::fromStdString(file.string()), QStringLiteral("-")});
  EXPECT_TRUE(reader.waitForFinished()) << "pdftotext of poppler-utils";
  return solid(QString::fromUtf8(reader.readAllStandardOutput()));
}

/// Returns how many bookmarks lead to the first page.
std::size_t bookmarksOfFirstPage(const std::string& pdf) {
  const std::string pages = pdf.substr(pdf.find("/Kids"));
  const std::string first = std::to_string(std::stoull(pages.substr(pages.find('[') + 1)));
  std::size_t count = 0;
  const std::string destination = "/Dest [ " + first + " 0 R ";
  for (std::size_t at = pdf.find(destination); at != std::string::npos; at = pdf.find(destination, at + 1)) {
    ++count;
  }
  return count;
}

TEST(ReportLanguage, ThePageForTheBoardIsOnePageWithItsSignaturesInBothLanguages) {
  ReportModel model = cohortReport(everything());
  const auto board = std::find_if(model.sections.begin(), model.sections.end(),
                                  [](const ReportSection& one) { return one.onFirstPage; });
  ASSERT_NE(board, model.sections.end());
  model.sections = {*board};
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "torsio-report-board.pdf";

  for (const std::string& language : reportLanguages()) {
    writePdfReport(model, file, wordingIn(language));

    EXPECT_EQ(bookmarksOfFirstPage(readFile(file)),
              1 + model.sections[0].figures.size() + model.sections[0].tables.size())
        << language << ": title, figure, standard and signatures begin on the first page";
  }
  std::filesystem::remove(file);
}

TEST(ReportLanguage, ReservationsWithoutRoomOnThePageForTheBoardAreCountedThereAndAllListedBehindIt) {
  CohortInputs in = everything();
  in.sites = {"Demonstration centre A", "Demonstration centre B"};
  in.freeze->sheetsAsked = 900;
  in.freeze->sheetsSubmitted = 2;
  in.freeze->whyIncomplete = "the board meets tomorrow and cannot wait for the other sheets to come in";
  in.imported = CohortOrigin{"Torsio", "set", std::string(64, 'c'), "admin", 1'767'600'000'000'000};
  for (std::size_t i = 0; i < 12; ++i) {
    in.trainees[i].withdrew = true;
  }
  std::erase_if(in.trainingMarks, [](const TrainingMark& mark) {
    return mark.occasion == 2 && (mark.trainee == "x101" || (mark.rater == "R104" && mark.group == 1));
  });
  for (TrainingMark& mark : in.trainingMarks) {
    mark.steps = std::min<std::int64_t>(100, mark.steps + (mark.group == 1 && mark.occasion == 0 ? 30 : 0));
  }
  ReportModel model = cohortReport(testing::scored(std::move(in)));
  ReportSection board = model.sections.front();
  ASSERT_TRUE(board.onFirstPage);
  std::vector<Text> reservations;
  for (const ReportParagraph& paragraph : board.paragraphs) {
    if (paragraph.reservation) {
      reservations.push_back(paragraph);
    }
  }
  ASSERT_GE(reservations.size(), 8U);
  model.sections = {board};
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / "torsio-report-reservations.pdf";
  for (const std::string& language : reportLanguages()) {
    const Wording wording = wordingIn(language);
    writePdfReport(model, file, wording);
    EXPECT_EQ(bookmarksOfFirstPage(readFile(file)), 1 + board.figures.size() + board.tables.size())
        << language;
    const QString second = pageText(file, 2);
    for (const Text& reservation : reservations) {
      EXPECT_TRUE(second.contains(solid(wording(reservation)))) << language << ": " << reservation.str();
    }
    const QString first = pageText(file, 1);
    EXPECT_TRUE(first.contains(solid(wording(reservations.front())))) << language;
    EXPECT_FALSE(first.contains(solid(wording(reservations.back())))) << language;
    EXPECT_TRUE(first.contains(language == "en" ? QStringLiteral("themostseriousfirst")
                                                : QStringLiteral("最重要的在前")))
        << first.toStdString();
  }
  std::filesystem::remove(file);
}

TEST(ReportLanguage, TheFirstPageIsFullOnlyOfTheBoardsAndKeepsItsMostSeriousReservation) {
  CohortInputs in = everything();
  for (std::size_t i = 0; i < 12; ++i) {
    in.trainees[i].withdrew = true;
  }
  for (CohortDose& dose : in.doses) {  // a long sentence about the training
    dose.virtual_min *= in.doses.front().trainee == dose.trainee ? 3.0 : 1.0;
  }
  in.markWays = {.live = 900};
  ReportModel model = cohortReport(std::move(in));
  const ReportSection board = model.sections.front();
  model.sections.resize(2);
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "torsio-report-full.pdf";
  for (const std::string& language : reportLanguages()) {
    const Wording wording = wordingIn(language);
    writePdfReport(model, file, wording);
    EXPECT_EQ(bookmarksOfFirstPage(readFile(file)), 1 + board.figures.size() + board.tables.size())
        << language << ": with the signatures";
    const QString first = pageText(file, 1);
    const auto serious = std::find_if(board.paragraphs.begin(), board.paragraphs.end(),
                                      [](const ReportParagraph& one) { return one.reservation; });
    ASSERT_NE(serious, board.paragraphs.end());
    EXPECT_TRUE(first.contains(solid(wording(*serious)))) << language;
    EXPECT_FALSE(first.contains(solid(wording(Text::tr("People are shown")))))
        << language << ": facts follow";
  }
  std::filesystem::remove(file);
}

TEST(ReportLanguage, RejectsAnUnsupportedLanguage) {
  EXPECT_THROW((void)wordingIn("tlh"), Error);
  for (const std::string& language : reportLanguages()) {
    EXPECT_NO_THROW((void)wordingIn(language));
  }
}

}  // namespace
}  // namespace torsio
