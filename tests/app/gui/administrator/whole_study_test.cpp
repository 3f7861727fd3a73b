// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's study as an administrator runs it, from the roster to the exported report, with real widgets
// and simulated marks; the exported numbers equal those of the command line.
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>

#include <QCheckBox>
#include <QComboBox>
#include <QDateTime>
#include <QLabel>
#include <QMessageBox>
#include <QRadioButton>
#include <QTableView>
#include <QTest>

#include "app/gui/administrator/curriculum/curricula_page.h"
#include "app/gui/administrator/curriculum/curriculum_editor.h"
#include "app/gui/administrator/people/roster_wizard.h"
#include "app/gui/administrator/reporting/reports_page.h"
#include "app/gui/administrator/reporting/results_page.h"
#include "app/gui/administrator/scoring/campaigns_page.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/administrator/study/allocation_page.h"
#include "app/gui/administrator/study/cohorts_page.h"
#include "app/gui/administrator/study/todays_sessions_page.h"
#include "app/gui/base/figure_card.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/outputs/report/report_export.h"
#include "app/services/devices/device_readiness.h"
#include "app/services/people/people_service.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/study/station_state.h"
#include "db/repository/trial/station_repository.h"
#include "sim/core/file_io.h"
#include "tests/app/gui/administrator/study_crowd.h"
#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui {
namespace {

namespace fs = std::filesystem;
using testing::AdministratorDesk;
using testing::answer;
using testing::StudyCentre;

/// Estimates the time of a user's actions with mouse and keys: keystroke-level model (Card, Moran and Newell
/// 1980), and silent reading at 238 words per minute (Brysbaert 2019).
class ByHand {
 public:
  /// Decide, point, press.
  void press(int times = 1) { needed_s_ += times * (kDecide_s + kPoint_s + kKey_s), presses_ += times; }
  void type(std::size_t keys) { needed_s_ += static_cast<double>(keys) * kKey_s, keys_ += keys; }
  void wait_s(double seconds) { needed_s_ += seconds; }
  /// Reads a part of a page of the guide once, from one text to another.
  void read(const std::filesystem::path& page, const std::string& from, const std::string& to) {
    const std::string text = readFile(page);
    const std::size_t begin = text.find(from);
    std::istringstream part(text.substr(begin, text.find(to, begin) - begin));
    std::size_t words = 0;
    for (std::string word; part >> word;) {
      ++words;
    }
    needed_s_ += static_cast<double>(words) * kWord_s;
    words_ += words;
  }
  [[nodiscard]] double minutes() const { return needed_s_ / 60.0; }
  [[nodiscard]] int presses() const { return presses_; }
  [[nodiscard]] std::size_t keys() const { return keys_; }
  [[nodiscard]] std::size_t words() const { return words_; }

 private:
  static constexpr double kDecide_s = 1.35;
  static constexpr double kPoint_s = 1.1;
  static constexpr double kKey_s = 0.28;
  static constexpr double kWord_s = 60.0 / 238.0;
  double needed_s_ = 0.0;
  int presses_ = 0;
  std::size_t keys_ = 0;
  std::size_t words_ = 0;
};

constexpr std::size_t kTrainees = 30;    // paper section 6
constexpr std::size_t kChiefs = 10;      // who score the trainees
constexpr std::size_t kEvaluators = 40;  // paper 5.3: 20 interns, 10 deputy chiefs, 10 chiefs

std::string internsFile() {
  std::string text = "Staff number;Full name;Sex;Level\r\n";
  for (std::size_t i = 1; i <= kTrainees; ++i) {
    text += "I-" + std::to_string(100 + i) + ";Intern " + std::to_string(i) +
            (i <= 17 ? ";male" : ";female") + (i % 2 == 0 ? ";graduate\r\n" : ";doctoral student\r\n");
  }
  return text;
}

std::string ratersFile(const std::string& prefix, const std::vector<std::pair<std::string, int>>& classes) {
  std::string text = "Staff number;Full name;Class\r\n";
  int number = 100;
  for (const auto& [name, count] : classes) {
    for (int i = 0; i < count; ++i) {
      const std::string id = prefix + std::to_string(++number);
      text.append(id).append(";Doctor ").append(id).append(";").append(name).append("\r\n");
    }
  }
  return text;
}

/// Estimated time that a person would need for the actions of this test.
ByHand& byHand() {
  static ByHand hand;
  return hand;
}

void pressByHand(QWidget& in, const QString& text) {
  byHand().press();
  testing::press(in, text);
}

void typeByHand(QDialog& dialog, const QString& text) {
  byHand().press(2);  // into the field, and the button below
  byHand().type(static_cast<std::size_t>(text.size()));
  testing::type(dialog, text);
}

/// Next, Next, Import.
void importRoster(AdministratorDesk& office, const std::string& text, bool raters, std::size_t expected) {
  byHand().press(9);  // page, import, file and its name, kind, two pages of the wizard, columns, import
  byHand().type(12);
  office.centre.as("administrator");
  const fs::path file = office.centre.folder() / "roster.csv";
  writeFileAtomically(file, text);
  RosterWizard wizard(office.shell());
  wizard.restart();
  wizard.show();
  child<QLineEdit>(wizard, "path").setText(toQString(file));
  for (QRadioButton* kind : wizard.findChildren<QRadioButton*>()) {
    if ((kind->text() == QStringLiteral("&Raters")) == raters) {
      kind->setChecked(true);
    }
  }
  wizard.button(QWizard::NextButton)->click();
  wizard.button(QWizard::NextButton)->click();
  office.shell().waitForJobs();
  ASSERT_TRUE(wizard.button(QWizard::FinishButton)->isEnabled());
  wizard.button(QWizard::FinishButton)->click();
  office.shell().waitForJobs();
  ASSERT_TRUE(wizard.outcome().has_value());
  EXPECT_EQ(wizard.outcome()->added, expected);
}

/// Selects only these lines of a dialog's list, by the codes in their first column.
void chooseCodes(QDialog& dialog, const std::vector<std::string>& codes) {
  byHand().press(2);  // the first, and the last with Shift
  QTableView& view = dialog.findChild<DataTable*>()->view();
  view.clearSelection();
  QItemSelection chosen;
  for (int row = 0; row < view.model()->rowCount(); ++row) {
    const std::string code = view.model()->index(row, 0).data().toString().toStdString();
    if (std::find(codes.begin(), codes.end(), code) == codes.end()) {
      continue;
    }
    chosen.select(view.model()->index(row, 0), view.model()->index(row, view.model()->columnCount() - 1));
  }
  view.selectionModel()->select(chosen, QItemSelectionModel::Select);
}

void makeCurriculum(AdministratorDesk& office) {
  auto page = office.open<CurriculaPage>("administrator");
  answer([](QDialog& dialog) { typeByHand(dialog, QStringLiteral("Twist skills 2026")); });
  pressByHand(*page, QStringLiteral("New curriculum"));
  EXPECT_TRUE(child<CurriculumEditor>(*page, "editor").problems().empty());
  answer([](QDialog& dialog) { typeByHand(dialog, QStringLiteral("as in the paper")); });
  pressByHand(*page, QStringLiteral("Publish"));
  pressByHand(*page, QStringLiteral("Begin"));
}

std::string makeCohort(AdministratorDesk& office) {
  auto page = office.open<CohortsPage>("administrator");
  answer([](QDialog& dialog) { typeByHand(dialog, QStringLiteral("Interns 2026")); });
  pressByHand(*page, QStringLiteral("New cohort"));
  byHand().press();
  answer([](QDialog& dialog) { dialog.accept(); });  // initially everybody is selected
  pressByHand(*page, QStringLiteral("Enrol trainees"));
  EXPECT_EQ(child<DataTable>(*page, "members").visibleRows(), static_cast<int>(kTrainees));
  return child<DataTable>(*page, "cohorts").currentId().toStdString();
}

void drawGroups(AdministratorDesk& office, const CohortId& cohortId) {
  auto administrator = office.open<AllocationPage>("administrator", toQString(cohortId));
  EXPECT_FALSE(testing::button(*administrator, QStringLiteral("Lock design"))->isEnabled());
  auto page = office.open<AllocationPage>("allocator", toQString(cohortId));
  auto* method = [&]() -> QComboBox* {
    for (QComboBox* box : page->findChildren<QComboBox*>()) {
      if (box->findData(static_cast<int>(AllocationMethod::kStratifiedBlocks)) >= 0) {
        return box;
      }
    }
    return nullptr;
  }();
  ASSERT_NE(method, nullptr);
  byHand().press(4);  // method, factor, question
  method->setCurrentIndex(method->findData(static_cast<int>(AllocationMethod::kStratifiedBlocks)));
  for (QCheckBox* factor : page->findChildren<QCheckBox*>()) {
    if (factor->text() == QStringLiteral("sex")) {
      factor->setChecked(true);
    }
  }
  pressByHand(*page, QStringLiteral("Preview balance"));
  EXPECT_GE(child<DataTable>(*page, "balance").visibleRows(),
            2);  // women and men, besides other data
  QTimer::singleShot(0, [] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    box->button(QMessageBox::Yes)->click();
  });
  pressByHand(*page, QStringLiteral("Lock design"));
  pressByHand(*page, QStringLiteral("Allocate everybody"));
  EXPECT_EQ(child<DataTable>(*page, "records").visibleRows(), static_cast<int>(kTrainees));
  const fs::path cards = office.centre.folder() / "cards.pdf";
  EXPECT_TRUE(page->writeCards(cards));
  EXPECT_EQ(readFile(cards).substr(0, 5), "%PDF-");
  EXPECT_EQ(office.centre.audited("allocation.cards"), 1);
}

void askChiefs(AdministratorDesk& office, const CohortId& cohortId, const std::vector<std::string>& chiefs) {
  auto page = office.open<ScoringPage>("administrator", toQString(cohortId));
  answer([&](QDialog& dialog) {
    chooseCodes(dialog, chiefs);
    dialog.accept();
  });
  pressByHand(*page, QStringLiteral("Invite raters"));
  EXPECT_EQ(child<DataTable>(*page, "matrix").visibleRows(), 90);  // 30 trainees at three occasions
}

void runTheDay(AdministratorDesk& office, const CohortId& cohortId) {
  const std::int64_t now_us = office.centre.session().now_us();
  StationState room{.station = "room 2", .heartbeatUtc_us = now_us};
  DeviceReadiness unfit{.device = Text::verbatim("Touch"), .haptic = true};
  unfit.findings = {{"connected", Light::kRed, Text::verbatim("no device answers"), ""}};
  storeDevice(stationDevice(unfit, now_us), room);
  StationRepository(office.centre.connection()).heartbeat(room);
  StationState yesterday{.station = "room 3", .heartbeatUtc_us = now_us};
  storeDevice(stationDevice(pointerReadiness(true), now_us - 86'400'000'000), yesterday);
  StationRepository(office.centre.connection()).heartbeat(yesterday);
  auto page = office.open<TodaysSessionsPage>("administrator", toQString(cohortId));
  EXPECT_EQ(child<DataTable>(*page, "table").visibleRows(), static_cast<int>(kTrainees));
  ASSERT_EQ(child<DataTable>(*page, "stations").visibleRows(), 2);
  const QString stations = child<DataTable>(*page, "stations").asText();
  const QString time =
      page->locale().toString(QDateTime::fromMSecsSinceEpoch(now_us / 1000).time(), QLocale::ShortFormat);
  EXPECT_TRUE(stations.contains(QStringLiteral("Touch\t\u2717 not fit at %1: no device answers").arg(time)))
      << stations.toStdString();
  EXPECT_TRUE(stations.contains(QStringLiteral("Mouse and keyboard\t\u25CB not checked today, last on ")));
  EXPECT_TRUE(child<QLabel>(*page, "alerts")
                  .text()
                  .contains(QStringLiteral("room 2: the device is not fit for graded runs")));
  child<DataTable>(*page, "table").view().selectRow(0);
  answer([](QDialog& dialog) { dialog.accept(); });  // 20 minutes on the real arm
  pressByHand(*page, QStringLiteral("Log time"));
  answer([](QDialog& dialog) {
    dialog.findChild<QLineEdit*>()->setText(QStringLiteral("on call"));
    dialog.accept();
  });
  pressByHand(*page, QStringLiteral("Swap turns"));
  // Two who swapped, and time logged before any sheet of the real arm was in.
  EXPECT_EQ(deviations(office.centre.session(), cohortId).size(), 3U);
  int listed = 0;
  answer([&listed](QDialog& dialog) {
    listed = child<DataTable>(dialog, "deviations").visibleRows();
    dialog.reject();
  });
  pressByHand(*page, QStringLiteral("Noted"));
  EXPECT_EQ(listed, 3);

  office.centre.passTime_us(60'000'000);
  // The page refreshes itself every few seconds.
  constexpr int kPatience_ms = 30'000;
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return child<QLabel>(*page, "alerts").text().contains(QStringLiteral("room 2 has not answered"));
      },
      kPatience_ms))
      << child<QLabel>(*page, "alerts").text().toStdString();
  EXPECT_TRUE(child<DataTable>(*page, "table").totals().contains(QStringLiteral("Deviations 3")));
  EXPECT_TRUE(page->leave());
}

std::vector<std::string> raterCodes(StudyCentre& centre, bool evaluators) {
  std::vector<std::string> codes;
  for (const NamedPersonRow& person : namedPeople(centre.as("administrator"))) {
    if (person.row.rater && (person.identity.externalId[0] == 'E') == evaluators) {
      codes.push_back(person.row.person.code);
    }
  }
  return codes;
}

void makeEvaluation(AdministratorDesk& office, const std::vector<std::string>& evaluators) {
  auto page = office.open<CampaignsPage>("administrator");
  answer([&](QDialog& dialog) {
    chooseCodes(dialog, evaluators);
    typeByHand(dialog, QStringLiteral("Nine indices"));
  });
  pressByHand(*page, QStringLiteral("New evaluation"));
  ASSERT_EQ(child<DataTable>(*page, "campaigns").visibleRows(), 1);
}

/// Counts the steps of the guide that this test does not perform: the first run, the two-person rule,
/// accounts of the allocator, the statistician and everybody on the roster, and the allocator's turn.
void countRemainingSteps(ByHand& hand) {
  hand.press(8);  // first run
  hand.type(75);
  hand.press(5);  // one administrator disables the two-person rule
  hand.type(20);
  for (int account = 0; account < 2; ++account) {
    hand.press(8);
    hand.type(12);
  }
  hand.press(7);  // accounts for the roster, and their cards
  hand.type(16);
  hand.wait_s(static_cast<double>(kTrainees + kChiefs + kEvaluators));
  for (int change = 0; change < 2; ++change) {  // sign out and in; with a new password the first time
    hand.press(5);
    hand.type(60);
  }
  hand.press(6);  // pages
}

TEST(WholeStudy, GoesFromTheRosterToTheReportWithTheNumbersOfTheCommandLine) {
  AdministratorDesk office;
  importRoster(office, internsFile(), false, kTrainees);
  importRoster(office, ratersFile("C-", {{"chief", 10}}), true, kChiefs);
  importRoster(office,
               ratersFile("E-", {{"intern", 20}, {"deputy chief physician", 10}, {"chief physician", 10}}),
               true, kEvaluators);
  const std::vector<std::string> chiefs = raterCodes(office.centre, false);
  makeCurriculum(office);
  const CohortId cohortId = makeCohort(office);
  drawGroups(office, cohortId);
  askChiefs(office, cohortId, chiefs);
  ByHand& hand = byHand();
  countRemainingSteps(hand);
  hand.read(fs::path(TORSIO_SOURCE_DIR) / "docs/user-guide/administrator.md", "# For administrators",
            "### 6. Today's sessions");
  EXPECT_LE(hand.minutes(), 45.0) << hand.presses() << " presses, " << hand.keys() << " keys, "
                                  << hand.words() << " words";
  RecordProperty("set_up_minutes", std::to_string(hand.minutes()));
  RecordProperty("set_up_presses", hand.presses());
  runTheDay(office, cohortId);
  makeEvaluation(office, raterCodes(office.centre, true));
  const testing::Crowd crowd = testing::crowdOf(office, cohortId, chiefs);
  testing::submitSheets(office.centre, cohortId, crowd);
  testing::submitEvaluationMarks(office, crowd);

  auto results = office.open<ResultsPage>("administrator");
  results->showItem(QStringLiteral("figure-22"));
  EXPECT_EQ(child<DataTable>(child<FigureCard>(*results, "card"), "table").visibleRows(), 10);
  auto reports = office.open<ReportsPage>("administrator");
  answer([](QDialog& dialog) { typeByHand(dialog, QStringLiteral("final")); });
  pressByHand(*reports, QStringLiteral("Freeze"));
  office.shell().waitForJobs();
  ASSERT_NE(reports->inputs(), nullptr);
  ASSERT_TRUE(reports->inputs()->freeze.has_value());
  EXPECT_TRUE(reports->inputs()->freeze->unchanged);
  const fs::path pdf = office.centre.folder() / "report.pdf";
  const fs::path csv = office.centre.folder() / "report.csv";
  ASSERT_TRUE(reports->exportTo(ReportFormat::kPdf, pdf));
  auto numbers = office.open<ReportsPage>("statistician");  // may see individual marks, by code
  ASSERT_TRUE(numbers->exportTo(ReportFormat::kCsv, csv));
  const fs::path tables = office.centre.folder() / "tables";
  ASSERT_TRUE(numbers->exportTables(tables));

  EXPECT_EQ(readFile(pdf).substr(0, 5), "%PDF-");
  testing::expectNumbersOfTheCommandLine(csv, crowd, office.centre.folder());
  EXPECT_EQ(office.centre.audited("report.export_coded"), 2);
  EXPECT_EQ(readFile(tables / "marks.csv").find("\xEF\xBB\xBFtrainee,rater,occasion,"), 0U);
  EXPECT_EQ(readFile(tables / "recordings.csv").find("\xEF\xBB\xBFtrial,trainee,scene,"), 0U);
  EXPECT_TRUE(office.failures.isEmpty()) << office.failures.join(QLatin1Char('\n')).toStdString();
}

}  // namespace
}  // namespace torsio::gui
