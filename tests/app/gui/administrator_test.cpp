// SPDX-License-Identifier: GPL-3.0-or-later
// The office through its real widgets: a whole study from the roster file to the report that leaves the
// house.
#include <filesystem>
#include <functional>
#include <map>

#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QInputDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QUrl>
#include <gtest/gtest.h>

#include "app/gui/administrator/administrator_pages.h"
#include "app/gui/administrator/curriculum/curricula_page.h"
#include "app/gui/administrator/curriculum/curriculum_editor.h"
#include "app/gui/administrator/people/accounts_dialog.h"
#include "app/gui/administrator/people/roster_wizard.h"
#include "app/gui/administrator/people/users_page.h"
#include "app/gui/administrator/reporting/export_dialog.h"
#include "app/gui/administrator/reporting/report_preview.h"
#include "app/gui/administrator/reporting/reports_page.h"
#include "app/gui/administrator/reporting/results_page.h"
#include "app/gui/administrator/scoring/campaigns_page.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/administrator/station/audit_page.h"
#include "app/gui/administrator/station/maintenance_page.h"
#include "app/gui/administrator/study/allocation_page.h"
#include "app/gui/administrator/study/cohorts_page.h"
#include "app/gui/administrator/study/run_day_page.h"
#include "app/gui/base/figure_canvas.h"
#include "app/gui/base/figure_card.h"
#include "app/gui/base/job_panel.h"
#include "app/gui/base/language.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/people/people_service.h"
#include "app/report/wording.h"
#include "app/reporting/report_export.h"
#include "app/study/curriculum_service.h"
#include "assessment/people/account.h"
#include "assessment/people/audit_entry.h"
#include "assessment/rating/assignment.h"
#include "assessment/rating/rubric.h"
#include "assessment/rating/sheet.h"
#include "assessment/report/cohort_report.h"
#include "assessment/report/figure_table.h"
#include "assessment/study/cohort.h"
#include "assessment/study/demonstration_marks.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "sim/base/file_io.h"
#include "sim/base/ids.h"
#include "tests/app/gui/administrator_desk.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio::gui {
namespace {

namespace fs = std::filesystem;
using testing::AdministratorDesk;
using testing::answer;
using testing::press;
using testing::StudyCentre;
using testing::type;

/// 30 made-up trainees as a hospital's spreadsheet has them.
fs::path rosterFile(const fs::path& folder, bool raters) {
  std::string text = raters ? "staff no;name;class\r\n" : "staff no;name;sex;level\r\n";
  for (int i = 1; i <= (raters ? 10 : 30); ++i) {
    text += (raters ? std::string("C-") : std::string("S-")).append(std::to_string(100 + i));
    text += raters ? ";Chief " : ";Intern ";
    text += std::to_string(i);
    text += raters ? ";chief" : (i % 2 == 0 ? ";female;graduate" : ";male;doctoral student");
    text += "\r\n";
  }
  const fs::path file = folder / (raters ? "raters.csv" : "interns.csv");
  writeFileAtomically(file, text);
  return file;
}

/// Through the three steps of the wizard, the columns chosen by hand where the headers do not tell.
std::size_t importFile(AdministratorDesk& office, const fs::path& file, RosterKind kind) {
  office.centre.as("administrator");
  RosterImport import;
  import.kind = kind;
  import.file = readRoster(file);
  import.columns = suggestColumns(*import.file, kind);
  import.columns[static_cast<std::size_t>(RosterField::kExternalId)] = 0;
  import.columns[static_cast<std::size_t>(RosterField::kFullName)] = 1;
  if (kind == RosterKind::kRaters) {
    import.columns[static_cast<std::size_t>(RosterField::kRaterClass)] = 2;
  }
  RosterPreviewPage preview(import, office.shell(), nullptr);
  preview.initializePage();
  office.shell().waitForJobs();
  EXPECT_TRUE(preview.isComplete());
  return importRoster(office.centre.session(), *import.file, kind, import.columns,
                      import.preview->fingerprint, RosterMode::kCommit)
      .added;
}

/// Every open sheet of the cohort, filled in by the stated rule of the demonstration.
void submitSimulatedMarks(StudyCentre& centre, const CohortId& cohortId) {
  SheetRepository sheets(centre.connection());
  DemonstrationPeople people;
  people.groups.resize(3);
  std::map<std::string, std::string> codeOf;
  for (const Enrolment& enrolment : enrolments(centre.as("allocator"), cohortId)) {
    people.groups.at(static_cast<std::size_t>(enrolment.groupCode.back() - '1'))
        .push_back(enrolment.traineeCode);
    codeOf[enrolment.id] = enrolment.traineeCode;
  }
  std::map<std::string, std::string> raterCode;
  for (const PersonRow& person : torsio::people(centre.as("administrator"))) {
    if (person.rater) {
      people.raters.push_back(person.person.code);
      raterCode[person.person.id] = person.person.code;
    }
  }
  people.raterClasses.resize(3);
  std::map<std::tuple<std::string, std::string, std::size_t>, std::int64_t> marks;
  for (const TrainingMark& mark : demonstrationTrainingMarks({10, 100, 10}, people, 5)) {
    marks[{mark.trainee, mark.rater, mark.occasion}] = mark.steps;
  }
  const std::map<std::string, std::size_t> occasions{{"pre", 0}, {"mid", 1}, {"post", 2}};
  for (const AssignmentStatus& status : sheets.assignments(cohortId)) {
    const Assignment& one = status.assignment;
    Sheet sheet;
    sheet.overall_steps =
        marks.at({codeOf.at(one.enrolmentId), raterCode.at(one.raterId), occasions.at(one.occasionCode)});
    const RubricRevision rubric = sheets.revision(one.rubricRevisionId).value();
    for (const RubricLine& row : rubric.rows) {
      sheet.rows.push_back({row.code, row.scale.lo, ""});
    }
    sheets.submit(one.id, centre.session().ids().newUuid(), sheet, "", centre.session().now_us());
  }
}

void setUpCurriculum(AdministratorDesk& office) {
  auto page = office.open<CurriculaPage>("administrator");
  answer([](QDialog& dialog) { type(dialog, QStringLiteral("Twist skills 2026")); });
  press(*page, QStringLiteral("New curriculum"));
  ASSERT_EQ(child<DataTable>(*page, "curricula").visibleRows(), 1);
  EXPECT_TRUE(child<CurriculumEditor>(*page, "editor").problems().empty());
  EXPECT_EQ(child<CurriculumEditor>(*page, "editor").content().arms.size(), 3U);
  answer([](QDialog& dialog) { type(dialog, QStringLiteral("first")); });
  press(*page, QStringLiteral("Publish"));
  press(*page, QStringLiteral("Begin"));
}

std::string setUpCohort(AdministratorDesk& office) {
  auto page = office.open<CohortsPage>("administrator");
  answer([](QDialog& dialog) { type(dialog, QStringLiteral("Interns 2026")); });
  press(*page, QStringLiteral("New cohort"));
  answer([](QDialog& dialog) { dialog.accept(); });  // everybody is chosen to begin with
  press(*page, QStringLiteral("Enrol trainees"));
  EXPECT_EQ(child<DataTable>(*page, "members").visibleRows(), 30);
  return child<DataTable>(*page, "cohorts").currentId().toStdString();
}

void allocateEverybody(AdministratorDesk& office, const CohortId& cohortId, int people) {
  auto page = office.open<AllocationPage>("allocator", toQString(cohortId));
  press(*page, QStringLiteral("Preview balance"));
  EXPECT_GT(child<DataTable>(*page, "balance").visibleRows(), 0);
  QTimer::singleShot(0, [] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    box->button(QMessageBox::Yes)->click();
  });
  press(*page, QStringLiteral("Lock design"));
  press(*page, QStringLiteral("Allocate everybody"));
  EXPECT_EQ(child<DataTable>(*page, "records").visibleRows(), people);
}

void askAllRaters(AdministratorDesk& office, const CohortId& cohortId) {
  auto page = office.open<ScoringPage>("administrator", toQString(cohortId));
  answer([](QDialog& dialog) {
    auto& raters = *dialog.findChild<DataTable*>();
    EXPECT_TRUE(raters.selectedIds().isEmpty());  // nothing is open yet
    EXPECT_FALSE(testing::button(dialog, QStringLiteral("Ask"))->isEnabled());
    raters.view().selectAll();
    EXPECT_TRUE(testing::button(dialog, QStringLiteral("Ask"))->isEnabled());
    dialog.accept();
  });
  press(*page, QStringLiteral("Invite raters"));
  answer([](QDialog& dialog) {
    auto& raters = *dialog.findChild<DataTable*>();
    EXPECT_EQ(raters.selectedIds().size(), raters.visibleRows());  // all have open sheets by now
    dialog.reject();
  });
  press(*page, QStringLiteral("Invite raters"));
  EXPECT_EQ(child<DataTable>(*page, "matrix").visibleRows(), 90);
}

/// What is listed and shown follows the language of the window; what was chosen stays chosen.
void expectResultsFollowTheLanguage(ResultsPage& results) {
  const QString english = child<QListWidget>(results, "contents").currentItem()->text();
  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);
  QCoreApplication::processEvents();

  EXPECT_EQ(child<QListWidget>(results, "contents").currentItem()->text().trimmed(),
            QStringLiteral("40 \u5206\u949f\u540e\u5404\u5b66\u5458\u7684\u5f97\u5206"));
  EXPECT_EQ(child<DataTable>(child<FigureCard>(results, "card"), "table").visibleRows(), 10);
  language.choose(Language::kEnglish);
  QCoreApplication::processEvents();
  EXPECT_EQ(child<QListWidget>(results, "contents").currentItem()->text(), english);
}

/// The report in the language chosen beside it, whatever that of the window.
/// Shows what will leave, and writes a workbook, pseudonymised tables and a gradebook.
void expectExports(ReportsPage& reports, ShellContext& shell, const fs::path& folder) {
  answer([&](QDialog& dialog) {
    auto& exported = dynamic_cast<ExportDialog&>(dialog);
    shell.waitForJobs();
    EXPECT_EQ(child<QTableWidget>(dialog, "rows").item(0, 0)->text().left(2), QStringLiteral("T-"));
    type(dialog, QStringLiteral("for the board"));
    exported.writeTo(folder / "cohort.xlsx");
    shell.waitForJobs();
    child<QComboBox>(dialog, "format").setCurrentIndex(1);
    child<QCheckBox>(dialog, "pseudonymised").setChecked(true);
    shell.waitForJobs();
    EXPECT_EQ(child<QTableWidget>(dialog, "rows").item(0, 0)->text().left(2), QStringLiteral("P-"));
    EXPECT_TRUE(child<QLabel>(dialog, "what").text().contains(QStringLiteral("shared by at least")));
    exported.writeTo(folder / "tables");
    shell.waitForJobs();
    child<QComboBox>(dialog, "format").setCurrentIndex(4);
    EXPECT_TRUE(
        child<QLabel>(dialog, "what").text().contains(QStringLiteral("Paths tell how somebody moves")));
    child<QLineEdit>(dialog, "title").setText(QStringLiteral("Twists"));
    exported.writeTo(folder / "set");
    shell.waitForJobs();
    EXPECT_TRUE(child<QLabel>(dialog, "done").text().contains(QStringLiteral("set")));
    child<QComboBox>(dialog, "format").setCurrentIndex(7);
    exported.writeTo(folder / "grades.csv");
    shell.waitForJobs();
    EXPECT_TRUE(child<QLabel>(dialog, "done").text().contains(QStringLiteral("grades.csv")));
    child<QCheckBox>(dialog, "pseudonymised").setChecked(false);  // all is read anew
    EXPECT_TRUE(child<JobPanel>(dialog, "job").isVisibleTo(&dialog));
    dialog.setResult(QDialog::Accepted);
    dialog.reject();  // the reading is given up first
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    shell.waitForJobs();
    QCoreApplication::processEvents();
    EXPECT_EQ(dialog.result(), QDialog::Rejected);
    EXPECT_FALSE(child<JobPanel>(dialog, "job").isVisibleTo(&dialog));
  });
  press(reports, QStringLiteral("Export"));
  EXPECT_EQ(readFile(folder / "cohort.xlsx").substr(0, 2), "PK");
  EXPECT_TRUE(fs::exists(folder / "tables" / "scores.sav"));
  EXPECT_EQ(readFile(folder / "grades.csv").substr(0, 23), "ID number,Email address");
  EXPECT_TRUE(fs::exists(folder / "set" / "datapackage.json"));
}

void expectReportInChinese(ReportsPage& reports, const fs::path& file) {
  EXPECT_TRUE(
      child<ReportPreview>(reports, "preview").toPlainText().contains(QStringLiteral("Methods and limits")));
  child<QComboBox>(reports, "language")
      .setCurrentIndex(child<QComboBox>(reports, "language").findData(QStringLiteral("zh_CN")));

  EXPECT_FALSE(
      child<ReportPreview>(reports, "preview").toPlainText().contains(QStringLiteral("Methods and limits")));
  EXPECT_TRUE(child<ReportPreview>(reports, "preview")
                  .toPlainText()
                  .contains(QStringLiteral("\u65b9\u6cd5\u4e0e\u5c40\u9650")));
  EXPECT_TRUE(reports.exportTo(ReportFormat::kPdf, file));
  EXPECT_NE(readFile(file).find("NotoSansCJK"), std::string::npos);
}

/// How deep a step of this kind stands below; 0: it is none.
int depthOf(const QTreeWidgetItem& item, const QString& kind) {
  for (int i = 0; i < item.childCount(); ++i) {
    if (item.child(i)->text(0).startsWith(kind)) {
      return 1;
    }
    if (const int below = depthOf(*item.child(i), kind); below > 0) {
      return below + 1;
    }
  }
  return 0;
}

/// Presses a group's mean in the preview and goes back to marks and program, then finds a person's numbers.
void expectNumbersLeadBack(ReportsPage& reports, ShellContext& shell) {
  auto& preview = child<ReportPreview>(reports, "preview");
  const QString page = preview.toHtml();
  const qsizetype at = page.indexOf(QStringLiteral("number:training%2Call%2CGroup%201"));
  ASSERT_GE(at, 0);
  const QUrl link(page.mid(at, page.indexOf(QLatin1Char('"'), at) - at));
  answer([&](QDialog& dialog) {
    shell.waitForJobs();
    auto& steps = child<QTreeWidget>(dialog, "steps");
    ASSERT_EQ(steps.topLevelItemCount(), 1);
    const QTreeWidgetItem& mean = *steps.topLevelItem(0);
    EXPECT_TRUE(mean.text(0).startsWith(QStringLiteral("mean of Group 1"))) << mean.text(0).toStdString();
    EXPECT_EQ(mean.childCount(), 11) << "ten scores and the program";
    EXPECT_EQ(depthOf(mean, QStringLiteral("score of T-")), 1);
    EXPECT_EQ(depthOf(mean, QStringLiteral("rater_mark of T-")), 2);
    EXPECT_EQ(depthOf(mean, QStringLiteral("submitted")), 3);
    EXPECT_EQ(depthOf(mean, QStringLiteral("scoring sheet")), 3);
    EXPECT_EQ(depthOf(mean, QStringLiteral("program file")), 1);
    auto& numbers = child<DataTable>(dialog, "numbers");
    EXPECT_EQ(dialog.focusWidget(), &numbers.filter()) << "a code is typed there";
    numbers.filter().setText(QStringLiteral("T-07"));
    EXPECT_EQ(numbers.visibleRows(), 3 * (1 + 10 + 3 + 30) + 3)
        << "at three occasions the score, ten marks, and as much for each of three criteria; the residual";
    dialog.reject();
  });
  Q_EMIT preview.anchorClicked(link);
}

TEST(AdministratorPages, RunsAWholeStudyFromTheRosterToTheReport) {
  AdministratorDesk office;

  EXPECT_EQ(importFile(office, rosterFile(office.centre.folder(), false), RosterKind::kTrainees), 30U);
  EXPECT_EQ(importFile(office, rosterFile(office.centre.folder(), true), RosterKind::kRaters), 10U);
  setUpCurriculum(office);
  const CohortId cohortId = setUpCohort(office);
  allocateEverybody(office, cohortId, 30);
  askAllRaters(office, cohortId);
  submitSimulatedMarks(office.centre, cohortId);

  auto board = office.open<RunDayPage>("administrator");
  EXPECT_EQ(child<DataTable>(*board, "table").visibleRows(), 30);
  EXPECT_TRUE(board->leave());
  auto results = office.open<ResultsPage>("administrator");
  results->showItem(QStringLiteral("figure-22"));
  EXPECT_EQ(child<DataTable>(child<FigureCard>(*results, "card"), "table").visibleRows(), 10);
  expectResultsFollowTheLanguage(*results);

  auto reports = office.open<ReportsPage>("administrator");
  answer([](QDialog& dialog) { type(dialog, QStringLiteral("final")); });
  press(*reports, QStringLiteral("Freeze"));
  office.shell().waitForJobs();
  ASSERT_NE(reports->inputs(), nullptr);
  ASSERT_TRUE(reports->inputs()->freeze.has_value());
  EXPECT_TRUE(reports->inputs()->freeze->unchanged);
  EXPECT_EQ(reports->inputs()->scores.size(), 90U);
  expectNumbersLeadBack(*reports, office.shell());
  const fs::path pdf = office.centre.folder() / "report.pdf";
  const fs::path csv = office.centre.folder() / "report.csv";
  EXPECT_TRUE(reports->exportTo(ReportFormat::kPdf, pdf));
  EXPECT_TRUE(reports->exportTo(ReportFormat::kCsv, csv));

  EXPECT_EQ(readFile(pdf).substr(0, 5), "%PDF-");
  EXPECT_NE(readFile(csv).find("icc_2_k"), std::string::npos);
  expectReportInChinese(*reports, office.centre.folder() / "chinese.pdf");
  EXPECT_EQ(office.centre.audited("report.export_coded"), 3);
  expectExports(*reports, office.shell(), office.centre.folder());
  EXPECT_EQ(office.centre.audited("report.export_coded"), 6);
  EXPECT_EQ(office.centre.audited("report.export_named"), 1);
  EXPECT_TRUE(office.failures.isEmpty()) << office.failures.join(QLatin1Char('\n')).toStdString();
}

TEST(AdministratorPages, EveryPageOpensOnAnEmptyRecordInBothThemes) {
  AdministratorDesk office;
  for (const PageEntry& entry : administratorPages()) {
    office.centre.as("administrator");
    if (!office.centre.session().may(factsOf(entry.id).needs)) {
      office.centre.as("allocator");
    }
    const std::unique_ptr<Page> page(entry.make(office.shell()));

    page->enter({});
    office.shell().waitForJobs();
    page->applyTheme(theme(ThemeKind::kDark));
    page->retranslate();

    EXPECT_FALSE(pageTitle(entry.id).isEmpty());
    EXPECT_TRUE(page->leave()) << pageText(entry.id).toStdString();
  }
  EXPECT_TRUE(office.failures.isEmpty()) << office.failures.join(QLatin1Char('\n')).toStdString();
}

TEST(AdministratorPages, NamedReportsNeedTheRightAndLeaveAnEntryOfTheirOwn) {
  AdministratorDesk office;
  office.centre.addTrainees(6);
  office.centre.runPaperCurriculum();
  auto cohorts = office.open<CohortsPage>("administrator");
  answer([](QDialog& dialog) { type(dialog, QStringLiteral("Six")); });
  press(*cohorts, QStringLiteral("New cohort"));
  answer([](QDialog& dialog) { dialog.accept(); });
  press(*cohorts, QStringLiteral("Enrol trainees"));
  allocateEverybody(office, child<DataTable>(*cohorts, "cohorts").currentId().toStdString(), 6);

  auto statistician = office.open<ReportsPage>("statistician");
  EXPECT_EQ(child<QComboBox>(*statistician, "identity").count(), 2);  // coded and aggregated
  auto administrator = office.open<ReportsPage>("administrator");
  ASSERT_EQ(child<QComboBox>(*administrator, "identity").count(), 3);
  child<QComboBox>(*administrator, "identity").setCurrentIndex(2);
  office.shell().waitForJobs();
  const fs::path file = office.centre.folder() / "named.csv";
  EXPECT_TRUE(administrator->exportTo(ReportFormat::kCsv, file));

  EXPECT_EQ(office.centre.audited("report.export_named"), 1);
  EXPECT_EQ(office.centre.audited("report.export_coded"), 0);
}

TEST(FigureCard, SpeaksTheLanguageOfTheWindowAndFollowsIt) {
  const ReportModel report = cohortReport(torsio::testing::demonstrationCohort());
  const auto figures = [&report](const std::string& id) {
    for (const ReportSection& section : report.sections) {
      for (const ReportFigure& figure : section.figures) {
        if (figure.id == id) {
          return figure;
        }
      }
    }
    return ReportFigure{};
  };
  LanguageSwitch language;
  FigureCard card;
  card.resize(700, 450);
  card.setFigure(figures("figure-training-means"));
  const auto* title = card.findChild<QLabel*>(QStringLiteral("cardTitle"));
  const QString english = title->text();
  const QString values = child<DataTable>(card, "table").asText();
  ASSERT_TRUE(values.contains(QStringLiteral("Group 1"))) << values.toStdString();

  language.choose(Language::kSimplifiedChinese);
  QCoreApplication::processEvents();

  EXPECT_EQ(title->text(), QStringLiteral("\u7814\u7a76\u671f\u95f4\u5404\u7ec4\u5e73\u5747\u5f97\u5206"));
  EXPECT_TRUE(child<DataTable>(card, "table").asText().contains(QStringLiteral("\u7b2c 1 \u7ec4")));
  EXPECT_FALSE(child<DataTable>(card, "table").asText().contains(QStringLiteral("Group")));
  EXPECT_TRUE(child<FigureCanvas>(card, "canvas")
                  .accessibleDescription()
                  .contains(QStringLiteral("\u7b2c 1 \u7ec4")));

  language.choose(Language::kEnglish);
  QCoreApplication::processEvents();
  EXPECT_EQ(title->text(), english);
  EXPECT_EQ(child<DataTable>(card, "table").asText(), values);
}

TEST(ReportPreview, ShowsTheReportInTheLanguageItWillBeWrittenIn) {
  const ReportModel report = cohortReport(torsio::testing::demonstrationCohort());
  ReportPreview preview;

  preview.setReport(report, wordingIn("zh_CN"));
  const QString chinese = preview.toPlainText();
  preview.setReport(report, wordingIn("en"));
  const QString english = preview.toPlainText();

  EXPECT_TRUE(chinese.contains(QStringLiteral("\u65b9\u6cd5\u4e0e\u5c40\u9650")));  // methods and limits
  EXPECT_FALSE(chinese.contains(QStringLiteral("Methods and limits")));
  EXPECT_TRUE(english.contains(QStringLiteral("Methods and limits")));
}

TEST(FigureCanvas, CopiesPictureAndTableAndSaysItsValues) {
  ReportFigure figure;
  figure.title = Text::verbatim("Scores");
  figure.categories = {Text::verbatim("a"), Text::verbatim("b")};
  FigureSeries series;
  series.name = Text::verbatim("Group 1");
  series.y = {1.25, std::nullopt};
  figure.series = {series};
  FigureCanvas canvas;
  canvas.resize(500, 300);
  canvas.setFigure(figure);

  QKeyEvent copy(QEvent::KeyPress, Qt::Key_C, Qt::ControlModifier);
  QApplication::sendEvent(&canvas, &copy);

  const QMimeData* got = QApplication::clipboard()->mimeData();
  ASSERT_NE(got, nullptr);
  EXPECT_TRUE(got->hasImage());
  EXPECT_EQ(got->text(), QStringLiteral("Category\tGroup 1\na\t1.25\nb\t"));
  EXPECT_EQ(canvas.accessibleName(), QStringLiteral("Scores"));
  EXPECT_TRUE(canvas.accessibleDescription().contains(QStringLiteral("Group 1 1.25")));
}

TEST(MaintenancePage, BacksUpTestsTheBackupAndChecksTheRecord) {
  AdministratorDesk office;
  office.centre.addTrainees(3);
  auto page = office.open<MaintenancePage>("administrator");

  const fs::path backup = office.centre.folder() / "backup.sqlite";
  page->backUp(backup);
  office.shell().waitForJobs();
  EXPECT_TRUE(fs::exists(backup));
  page->testBackup(backup);
  office.shell().waitForJobs();
  EXPECT_TRUE(child<QLabel>(*page, "backupText").text().contains(QStringLiteral("can be restored")));
  page->checkRecord();
  office.shell().waitForJobs();

  EXPECT_TRUE(child<QLabel>(*page, "recordText").text().contains(QStringLiteral("sound")));
  EXPECT_TRUE(office.failures.isEmpty()) << office.failures.join(QLatin1Char('\n')).toStdString();
}

TEST(UsersPage, MakesTheAccountsOfTheWholeRosterAndTellsTheirPasswordsOnce) {
  AdministratorDesk office;
  office.centre.addTrainees(3);
  auto page = office.open<UsersPage>("administrator");
  const fs::path cards = office.centre.folder() / "cards.pdf";
  QString copied;
  QTimer waiting;
  QObject::connect(&waiting, &QTimer::timeout, [&] {
    auto* dialog = qobject_cast<AccountsDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) {
      return;
    }
    waiting.stop();
    QTimer::singleShot(0, [] {  // closing at once is asked about
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(question, nullptr);
      question->button(QMessageBox::No)->click();
    });
    dialog->reject();
    EXPECT_TRUE(dialog->isVisible());
    dialog->copy();
    copied = QApplication::clipboard()->text();
    dialog->saveCards(cards);
    dialog->reject();
  });

  answer([](QDialog& dialog) { dialog.accept(); });
  waiting.start(1);
  press(*page, QStringLiteral("Accounts for the roster"));
  office.shell().waitForJobs();

  EXPECT_EQ(office.centre.audited("user.add"), 3);
  EXPECT_TRUE(readFile(cards).starts_with("%PDF"));
  const QStringList lines = copied.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  ASSERT_EQ(lines.size(), 4);  // headings and three people
  const QStringList first = lines[1].split(QLatin1Char('\t'));
  ASSERT_EQ(first.size(), 3);
  EXPECT_EQ(first[1], QStringLiteral("t-01"));
  EXPECT_EQ(signIn(office.centre.session(), "t-01", first[2].toStdString()).outcome, SignIn::kMustChange);
}

TEST(AuditPage, ShowsTheNewestThousandAtOnceAndTheOthersOnRequest) {
  AdministratorDesk office;
  const NewAuditEntry one{.atUtc_us = office.centre.session().now_us(),
                          .actor = "u",
                          .station = "s",
                          .action = AuditAction::kPersonChange,
                          .objectKind = AuditObject::kPerson};
  const std::vector<NewAuditEntry> entries(2'500, one);
  AuditRepository trail(office.centre.connection());
  trail.append(entries);
  const std::int64_t all = trail.count(0);

  const auto page = office.open<AuditPage>("administrator");
  page->findChild<QComboBox*>()->setCurrentIndex(3);  // everything
  const auto& table = *page->findChild<DataTable*>();
  auto& more = *page->findChild<QToolButton*>(QStringLiteral("more"));
  EXPECT_EQ(table.visibleRows(), 1'000);
  EXPECT_FALSE(more.isHidden());
  more.click();
  EXPECT_EQ(table.visibleRows(), 2'000);
  more.click();

  EXPECT_EQ(table.visibleRows(), all);
  EXPECT_TRUE(more.isHidden());
}

}  // namespace
}  // namespace torsio::gui
