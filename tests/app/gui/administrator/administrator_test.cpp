// SPDX-License-Identifier: GPL-3.0-or-later
// The administrator's pages with real widgets: a whole study from the roster file to the exported report.
// The roster wizard with its real buttons, from the file to the people in the record.

#include <filesystem>

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QRadioButton>
#include <QTableWidget>
#include <QTimer>
#include <QTreeWidget>
#include <QUrl>
#include <gtest/gtest.h>

#include "app/gui/administrator/curriculum/curricula_page.h"
#include "app/gui/administrator/curriculum/curriculum_editor.h"
#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/people/roster_wizard.h"
#include "app/gui/administrator/reporting/export_dialog.h"
#include "app/gui/administrator/reporting/report_preview.h"
#include "app/gui/administrator/reporting/reports_page.h"
#include "app/gui/administrator/reporting/results_page.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/administrator/study/allocation_page.h"
#include "app/gui/administrator/study/cohorts_page.h"
#include "app/gui/administrator/study/todays_sessions_page.h"
#include "app/gui/base/figure_card.h"
#include "app/gui/base/job_panel.h"
#include "app/gui/base/language.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/outputs/report/report_export.h"
#include "app/services/people/people_service.h"
#include "app/services/study/curriculum_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "sim/core/file_io.h"
#include "tests/app/gui/administrator/study_crowd.h"
#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui {

namespace {

namespace fs = std::filesystem;
using testing::AdministratorDesk;
using testing::answer;
using testing::press;
using testing::StudyCentre;
using testing::type;

/// 30 invented trainees in a hospital's spreadsheet.
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

/// Runs the three steps of the wizard, choosing columns by hand where headings do not suffice.
std::size_t importFile(AdministratorDesk& office, const fs::path& file, RosterKind kind) {
  office.centre.as("administrator");
  RosterImport import{.kind = kind, .file = readRoster(file)};
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

/// Fills in every open sheet of the cohort by the demonstration's rule.
void submitSimulatedMarks(StudyCentre& centre, const CohortId& cohortId) {
  testing::Crowd crowd;
  crowd.people.groups.resize(3);
  for (const Enrolment& enrolment : enrolments(centre.as("allocator"), cohortId)) {
    crowd.people.groups.at(static_cast<std::size_t>(enrolment.groupCode.back() - '1'))
        .push_back(enrolment.traineeCode);
    crowd.codeOf[enrolment.id] = enrolment.traineeCode;
  }
  for (const PersonRow& person : torsio::people(centre.as("administrator"))) {
    if (person.rater) {
      crowd.people.raters.push_back(person.person.code);
      crowd.idOf[person.person.code] = person.person.id;
    }
  }
  crowd.people.raterClasses.resize(3);
  testing::submitSheets(centre, cohortId, crowd);
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
  answer([](QDialog& dialog) { dialog.accept(); });  // initially everybody is selected
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
    EXPECT_EQ(raters.selectedIds().size(), raters.visibleRows());  // by now, all have open sheets
    dialog.reject();
  });
  press(*page, QStringLiteral("Invite raters"));
  EXPECT_EQ(child<DataTable>(*page, "matrix").visibleRows(), 90);
}

/// Contents follow the window's language; the selection stays.
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

void chooseForm(QDialog& dialog, ExportDialog::Form form) {
  auto& formats = child<QComboBox>(dialog, "format");
  formats.setCurrentIndex(formats.findData(static_cast<int>(form)));
  ASSERT_GE(formats.currentIndex(), 0);
}

/// The report in the language chosen on the page, whatever the window's. Shows a preview of the export, and
/// writes a workbook, pseudonymised tables and a gradebook.
void expectExports(ReportsPage& reports, ShellContext& shell, const fs::path& folder) {
  answer([&](QDialog& dialog) {
    auto& exported = dynamic_cast<ExportDialog&>(dialog);
    shell.waitForJobs();
    EXPECT_EQ(child<QTableWidget>(dialog, "rows").item(0, 0)->text().left(2), QStringLiteral("T-"));
    EXPECT_TRUE(
        child<QLabel>(dialog, "as-in-file").text().contains(QStringLiteral("exactly as the file will hold")));
    type(dialog, QStringLiteral("for the board"));
    exported.writeTo(folder / "cohort.xlsx");
    shell.waitForJobs();
    chooseForm(dialog, ExportDialog::Form::kSpss);
    child<QCheckBox>(dialog, "pseudonymised").setChecked(true);
    shell.waitForJobs();
    EXPECT_EQ(child<QTableWidget>(dialog, "rows").item(0, 0)->text().left(2), QStringLiteral("P-"));
    EXPECT_TRUE(child<QLabel>(dialog, "what").text().contains(QStringLiteral("shared by at least")));
    exported.writeTo(folder / "tables");
    shell.waitForJobs();
    chooseForm(dialog, ExportDialog::Form::kFrictionless);
    EXPECT_TRUE(
        child<QLabel>(dialog, "what").text().contains(QStringLiteral("Paths reveal how a person moves")));
    child<QLineEdit>(dialog, "title").setText(QStringLiteral("Twists"));
    exported.writeTo(folder / "set");
    shell.waitForJobs();
    EXPECT_TRUE(child<QLabel>(dialog, "done").text().contains(QStringLiteral("set")));
    chooseForm(dialog, ExportDialog::Form::kReplication);
    exported.writeTo(folder / "package");
    shell.waitForJobs();
    EXPECT_TRUE(fs::exists(folder / "package" / "marks.csv"));
    chooseForm(dialog, ExportDialog::Form::kMoodle);
    exported.writeTo(folder / "grades.csv");
    shell.waitForJobs();
    EXPECT_TRUE(child<QLabel>(dialog, "done").text().contains(QStringLiteral("grades.csv")));
    child<QCheckBox>(dialog, "pseudonymised").setChecked(false);  // rereads everything
    EXPECT_TRUE(child<JobPanel>(dialog, "job").isVisibleTo(&dialog));
    dialog.setResult(QDialog::Accepted);
    dialog.reject();  // cancels reading first
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

/// Returns the depth of a step of this kind below the item; 0: none.
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

/// Clicks a group's mean in the preview and traces it to marks and program, then finds a person's numbers.
void expectNumbersAreTraceable(ReportsPage& reports, ShellContext& shell) {
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
    EXPECT_EQ(numbers.visibleRows(), 3 * (1 + 10 + 3 + 30) + 3 + 2 * 10 + 2 + 20)
        << "at three occasions the score, ten marks, and as much for each of three criteria; the residual; "
           "each mark beside the mean of the others; how many marks, and whether the trainee withdrew; "
           "level, failures, excused runs, error rates and odds at the required exercise";
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

  auto board = office.open<TodaysSessionsPage>("administrator");
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
  expectNumbersAreTraceable(*reports, office.shell());
  const fs::path pdf = office.centre.folder() / "report.pdf";
  const fs::path csv = office.centre.folder() / "report.csv";
  EXPECT_TRUE(reports->exportTo(ReportFormat::kPdf, pdf));
  EXPECT_TRUE(reports->exportTo(ReportFormat::kCsv, csv));

  EXPECT_EQ(readFile(pdf).substr(0, 5), "%PDF-");
  EXPECT_NE(readFile(csv).find("icc_2_k"), std::string::npos);
  expectReportInChinese(*reports, office.centre.folder() / "chinese.pdf");
  EXPECT_EQ(office.centre.audited("report.export_coded"), 3);
  expectExports(*reports, office.shell(), office.centre.folder());
  EXPECT_EQ(office.centre.audited("report.export_coded"), 7);
  EXPECT_EQ(office.centre.audited("report.export_named"), 1);
  EXPECT_TRUE(office.failures.isEmpty()) << office.failures.join(QLatin1Char('\n')).toStdString();
}

TEST(AdministratorPages, NamedReportsNeedTheRightAndAreAudited) {
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

namespace fs = std::filesystem;

/// The wizard on its first page, with a file of this text.
class RosterWizardTest : public ::testing::Test {
 protected:
  void SetUp() override { office.centre.as("administrator"); }

  RosterWizard& open(const std::string& text, bool raters = false) {
    const fs::path file = office.centre.folder() / "roster.csv";
    writeFileAtomically(file, text);
    wizard = std::make_unique<RosterWizard>(office.shell());
    wizard->restart();
    wizard->show();
    child<QLineEdit>(*wizard, "path").setText(toQString(file));
    for (QRadioButton* kind : wizard->findChildren<QRadioButton*>()) {
      if ((kind->text() == QStringLiteral("&Raters")) == raters) {
        kind->setChecked(true);
      }
    }
    return *wizard;
  }
  void next() {
    ASSERT_TRUE(wizard->button(QWizard::NextButton)->isEnabled());
    wizard->button(QWizard::NextButton)->click();
    office.shell().waitForJobs();
  }
  void choose(RosterField field, const char* column) {
    auto* box =
        wizard->currentPage()->findChild<QComboBox*>(QString::fromLatin1(rosterFieldCode(field).data()));
    ASSERT_NE(box, nullptr);
    box->setCurrentIndex(box->findText(QString::fromLatin1(column)));
  }
  DataTable& lines() { return *wizard->currentPage()->findChild<DataTable*>(); }
  QAbstractButton& import() { return *wizard->button(QWizard::FinishButton); }
  std::size_t known() { return torsio::people(office.centre.session()).size(); }

  AdministratorDesk office;
  std::unique_ptr<RosterWizard> wizard;
};

TEST_F(RosterWizardTest, ImportsAFileWithColumnsChosenByHand) {
  open("Kennung;Wer;Geschlecht\nS-1;Ann Smith;f\nS-2;Bo Chen;m\nS-3;Cy Diaz;m\n");

  next();
  EXPECT_FALSE(wizard->button(QWizard::NextButton)->isEnabled()) << "the headers tell nothing yet";
  choose(RosterField::kExternalId, "Kennung");
  choose(RosterField::kFullName, "Wer");
  choose(RosterField::kSex, "Geschlecht");
  next();
  ASSERT_EQ(lines().visibleRows(), 3);
  ASSERT_EQ(known(), 0U) << "the dry run leaves nothing behind";
  ASSERT_TRUE(import().isEnabled());
  import().click();
  office.shell().waitForJobs();

  EXPECT_EQ(wizard->result(), QDialog::Accepted);
  ASSERT_TRUE(wizard->outcome().has_value());
  EXPECT_EQ(wizard->outcome()->added, 3U);
  const auto named = namedPeople(office.centre.session());
  ASSERT_EQ(named.size(), 3U);
  for (const NamedPersonRow& one : named) {
    EXPECT_EQ(one.row.person.sex, one.identity.externalId == "S-1" ? "female" : "male");
  }
  EXPECT_EQ(office.centre.audited("roster.import"), 1);
}

TEST_F(RosterWizardTest, AFileOfRatersIsDetectedBeforeTheyBecomeTrainees) {
  open("Staff number,Full name,Class\nC-1,Ann Smith,chief physician\n");
  next();
  auto& hint = child<QLabel>(*wizard, "rosterHint");
  EXPECT_FALSE(hint.isHidden());
  EXPECT_TRUE(hint.text().contains(QStringLiteral("The column Class"))) << hint.text().toStdString();
  wizard->button(QWizard::CancelButton)->click();

  open("Staff number,Full name,Sex\nS-1,Bo Chen,m\n");
  next();
  EXPECT_TRUE(child<QLabel>(*wizard, "rosterHint").isHidden());
}

TEST_F(RosterWizardTest, ImportsNothingIfAnyLineIsWrongAndSaysWhatToCorrect) {
  open("Staff ID,Name,Age\nS-1,Ann Smith,24\nS-2,,25\nS-1,Twice,26\nS-4,Old,250\n");

  next();
  next();

  EXPECT_FALSE(import().isEnabled());
  const QString shown = lines().asText();
  EXPECT_TRUE(shown.contains(QStringLiteral("Full name is missing")) &&
              shown.contains(QStringLiteral("is already on line 2")) &&
              shown.contains(QStringLiteral("not a plausible age")))
      << shown.toStdString();
  wizard->button(QWizard::CancelButton)->click();
  EXPECT_EQ(known(), 0U);
  EXPECT_EQ(office.centre.audited("roster.import"), 0);
}

TEST_F(RosterWizardTest, TheReasonOfAnErrorIsReadInFullAndAFilterIsForOneFile) {
  open("Staff ID,Name,E-mail\nS-1,Ann Smith,a@x.org\ns\xEF\xBC\x8D\x31,Bo Chen,b@x.org\nS-3,,c@x.org\n");
  next();
  next();
  const auto& note = child<QLabel>(*wizard, "rosterNote");
  EXPECT_TRUE(note.text().startsWith(QStringLiteral("Line 3: "))) << note.text().toStdString();
  EXPECT_TRUE(note.text().contains(QStringLiteral("looks like that of line 2"))) << note.text().toStdString();
  EXPECT_LE(note.heightForWidth(note.width()), note.height());
  lines().select(QStringLiteral("4"));
  EXPECT_TRUE(note.text().contains(QStringLiteral("is missing"))) << note.text().toStdString();

  const int top = lines().y();
  lines().filter().setText(QStringLiteral("Bo"));
  ASSERT_EQ(lines().visibleRows(), 1);
  wizard->back();
  wizard->back();
  writeFileAtomically(office.centre.folder() / "roster.csv", "Staff ID,Name,E-mail\nS-1,Ann Smith,a@x.org\n");
  next();
  next();
  EXPECT_EQ(lines().visibleRows(), 1) << "a filter for another file";
  EXPECT_EQ(lines().y(), top);
  EXPECT_TRUE(note.text().isEmpty()) << note.text().toStdString();
}

TEST_F(RosterWizardTest, ACorrectedFileKeepsItsColumnsAndEmptyOrDuplicateLinesAreNoObstacle) {
  open("Kennung;Wer;Jahre;Bemerkung\nS-1;Ann Smith;24;erste\nS-2;Bo Chen;250;zweite\n");
  next();
  EXPECT_TRUE(lines().asText().contains(QStringLiteral("Bemerkung"))) << "every column of the file is shown";
  EXPECT_TRUE(lines().asText().contains(QStringLiteral("zweite")));
  choose(RosterField::kExternalId, "Kennung");
  choose(RosterField::kFullName, "Wer");
  choose(RosterField::kAge, "Jahre");
  next();
  EXPECT_FALSE(import().isEnabled()) << "an age of 250";
  wizard->button(QWizard::CancelButton)->click();

  open(
      "Kennung;Wer;Jahre;Bemerkung\nS-1;Ann Smith;24;erste\n;;;\nS-2;Bo Chen;25;zweite\nS-2;Bo "
      "Chen;25;zweite\n");
  next();
  ASSERT_TRUE(wizard->button(QWizard::NextButton)->isEnabled()) << "the choices are remembered";
  next();
  ASSERT_TRUE(import().isEnabled()) << lines().asText().toStdString();
  import().click();
  office.shell().waitForJobs();

  EXPECT_EQ(wizard->outcome()->added, 2U);
  for (const NamedPersonRow& one : namedPeople(office.centre.session())) {
    EXPECT_EQ(one.row.person.age_years, one.identity.externalId == "S-1" ? 24 : 25);
  }
}

TEST_F(RosterWizardTest, IdentifiesPeopleByNumberAndChangesOnlyDifferences) {
  open("Staff ID,Name,E-mail\nS-1,Ann Smith,ann@example.org\n");
  next();
  next();
  import().click();
  office.shell().waitForJobs();

  // The same number with a new name; the same address with a new number.
  open("Staff ID,Name,E-mail\nS-1,Ann Miller,ann@example.org\nS-9,Other Ann,ann@example.org\n");
  next();
  next();
  EXPECT_TRUE(lines().asText().contains(QStringLiteral("Ann Smith")));
  EXPECT_TRUE(lines().asText().contains(QStringLiteral("belongs to T-01 already")));
  import().click();
  office.shell().waitForJobs();

  EXPECT_EQ(wizard->outcome()->added, 1U);
  EXPECT_EQ(wizard->outcome()->changed, 1U);
  EXPECT_EQ(known(), 2U);
}

TEST_F(RosterWizardTest, StopsDuringTenThousandAndStoresNothing) {
  std::string text = "Staff ID,Name\n";
  for (int i = 0; i < 10'000; ++i) {
    text += "S-" + std::to_string(i) + ",Intern " + std::to_string(i) + "\n";
  }
  open(text);
  next();
  wizard->button(QWizard::NextButton)->click();
  EXPECT_FALSE(import().isEnabled());
  int signs = 0;
  QObject::connect(&office.shell(), &ShellContext::jobMoved, [&](const QString& step) {
    if (step == QStringLiteral("Trying it out") && ++signs == 3) {
      wizard->button(QWizard::CancelButton)->click();
    }
  });

  office.shell().waitForJobs();
  QApplication::processEvents();

  EXPECT_GE(signs, 3);
  EXPECT_EQ(wizard->result(), QDialog::Rejected);
  EXPECT_FALSE(wizard->isVisible());
  EXPECT_EQ(known(), 0U);
}

TEST_F(RosterWizardTest, ImportsTenThousandWhileTheWindowStaysResponsive) {
  constexpr int kPeople = 10'000;
  // A frozen window would be frozen for the dry run or the import, both of which take longer on a busy
  // machine.
  constexpr qint64 kFrozen_ms = 1'000;
  std::string text = "Staff ID,Name,Sex\n";
  for (int i = 0; i < kPeople; ++i) {
    text += "S-" + std::to_string(i) + ",Intern " + std::to_string(i) + (i % 2 == 0 ? ",f\n" : ",m\n");
  }
  open(text);
  next();
  QElapsedTimer since;
  since.start();
  qint64 longest_ms = 0;
  QTimer beat;
  QElapsedTimer last;
  QObject::connect(&beat, &QTimer::timeout, [&] { longest_ms = std::max(longest_ms, last.restart()); });
  last.start();
  beat.start(10);

  next();
  const qint64 preview_ms = since.restart();
  ASSERT_EQ(lines().visibleRows(), kPeople);
  import().click();
  office.shell().waitForJobs();
  const qint64 commit_ms = since.elapsed();

  RecordProperty("preview_ms", static_cast<int>(preview_ms));
  RecordProperty("commit_ms", static_cast<int>(commit_ms));
  RecordProperty("longest_pause_ms", static_cast<int>(longest_ms));
  EXPECT_EQ(wizard->outcome()->added, static_cast<std::size_t>(kPeople));
  EXPECT_EQ(known(), static_cast<std::size_t>(kPeople));
  EXPECT_LT(longest_ms, std::max(kFrozen_ms, std::min(preview_ms, commit_ms) / 2));
}

}  // namespace

}  // namespace torsio::gui
