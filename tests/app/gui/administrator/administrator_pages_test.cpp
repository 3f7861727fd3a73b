// SPDX-License-Identifier: GPL-3.0-or-later
// Individual pages of administrators, and the figures of reports. Long lists of administrators: what is
// displayed, found by the search, and remembered.

#include "app/gui/administrator/administrator_pages.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDateEdit>
#include <QDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTableView>
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextTable>
#include <QTimer>
#include <QToolButton>
#include <gtest/gtest.h>

#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/people/shown_once_dialog.h"
#include "app/gui/administrator/people/users_page.h"
#include "app/gui/administrator/reporting/report_preview.h"
#include "app/gui/administrator/station/audit_page.h"
#include "app/gui/administrator/station/installation_dialog.h"
#include "app/gui/administrator/station/maintenance_page.h"
#include "app/gui/base/figure_card.h"
#include "app/gui/base/language.h"
#include "app/gui/base/page.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/program/window_main.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/outputs/wording/wording.h"
#include "app/services/base/csv_table.h"
#include "app/services/maintenance/retention.h"
#include "app/services/people/people_service.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/people/retention.h"
#include "assessment/results/cohort_report.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"
#include "tests/app/gui/support/administrator_desk.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio::gui {

namespace {

namespace fs = std::filesystem;
using testing::AdministratorDesk;
using testing::answer;
using testing::press;

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

TEST(FigureCard, IsInTheWindowsLanguageAndFollowsItsChange) {
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

TEST(ReportPreview, ShowsTheReportInTheLanguageInWhichItWillBeWritten) {
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

/// On a page as wide as a 4K window, tables use the width, but running text keeps a readable line length.
TEST(ReportPreview, KeepsLinesOfTextShortHoweverWideThePage) {
  const ReportModel report = cohortReport(torsio::testing::demonstrationCohort());
  ReportPreview preview;
  preview.show();
  preview.setReport(report, wordingIn("en"));
  const int longest = 90 * preview.fontMetrics().averageCharWidth();
  for (const int width : {900, 3000, 1400}) {
    preview.resize(width, 800);
    QApplication::processEvents();

    int lines = 0;
    for (QTextBlock block = preview.document()->begin(); block.isValid(); block = block.next()) {
      if (QTextCursor(block).currentTable() != nullptr || block.text().size() < 200) {
        continue;
      }
      for (int line = 0; line < block.layout()->lineCount(); ++line) {
        ++lines;
        EXPECT_LE(block.layout()->lineAt(line).naturalTextWidth(), longest) << block.text().toStdString();
      }
    }
    EXPECT_GT(lines, 10);
  }
}

/// Returns the first cells of tables that extend beyond the page.
std::string tooWide(const ReportPreview& preview) {
  std::string names;
  const double edge = preview.viewport()->width();
  for (QTextFrame* frame : preview.document()->rootFrame()->childFrames()) {
    const auto* table = qobject_cast<const QTextTable*>(frame);
    const QRectF area = preview.document()->documentLayout()->frameBoundingRect(frame);
    if (table == nullptr || area.right() <= edge) {
      continue;
    }
    names += std::to_string(static_cast<int>(area.width())) + " px: ";
    for (int c = 0; c < table->columns(); ++c) {
      names += table->cellAt(0, c).firstCursorPosition().block().text().toStdString() + " | ";
    }
    names += "\n";
  }
  return names;
}

TEST(ReportPreview, HasAPageOfReadableWidthAndNeverNeedsTheHorizontalScrollBar) {
  const ReportModel report = cohortReport(torsio::testing::demonstrationCohort());
  ReportPreview preview;
  preview.show();
  for (const char* language : {"en", "zh_CN"}) {
    preview.setReport(report, wordingIn(language));
    for (const int width : {1128, 3600, 1000}) {  // in windows of 1366, 3840 and 1280 pixels
      preview.resize(width, 800);
      QApplication::processEvents();

      EXPECT_FALSE(preview.horizontalScrollBar()->isVisible()) << language << ", " << width;
      EXPECT_EQ(tooWide(preview), "") << language << ", " << width;
      EXPECT_LE(preview.viewport()->width(), 1121);
      const int beside = preview.width() - preview.viewport()->width();
      EXPECT_NEAR(preview.viewport()->x(), beside / 2, 20) << width;
    }
  }
}

/// Returns the longest run of one colour within the hatched bar in the middle of a canvas `width` wide, px.
int widestStripe(int width) {
  ReportFigure figure;
  figure.categories = {Text::verbatim("a")};
  for (const char* name : {"1", "2", "3"}) {
    FigureSeries series;
    series.name = Text::verbatim("%1", std::string(name));
    series.y = {10.0};
    figure.series.push_back(series);
  }
  FigureCanvas canvas;
  canvas.resize(width, width / 2);
  canvas.setFigure(figure);
  canvas.show();
  QApplication::processEvents();

  const QImage seen = canvas.grab().toImage();
  const int y = seen.height() / 2;
  int widest = 0;
  int run = 0;
  for (int x = seen.width() * 48 / 100; x < seen.width() * 52 / 100; ++x) {
    run = seen.pixelColor(x, y) == seen.pixelColor(x - 1, y) ? run + 1 : 1;
    widest = std::max(widest, run);
  }
  return widest;
}

TEST(FigureCanvas, HatchesOfAChartOnA4kScreenAreTwiceAsWide) {
  const int usual = widestStripe(900);
  const int wide = widestStripe(3600);

  EXPECT_GE(usual, 2);
  EXPECT_GE(wide, 2 * usual);
  EXPECT_LE(wide, 40) << "the bar is not hatched";
}

TEST(FigureCanvas, CopiesPictureAndTableAndDescribesItsValues) {
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

TEST(MaintenancePage, MakesABackupTestsItAndChecksTheRecord) {
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
  EXPECT_TRUE(child<QLabel>(*page, "diskText").text().startsWith(QStringLiteral("Disk in use: ")));
  EXPECT_TRUE(office.failures.isEmpty()) << office.failures.join(QLatin1Char('\n')).toStdString();
}

TEST(MaintenancePage, ShowsWhatThisComputerLacksTheWorstFirst) {
  AdministratorDesk office;
  auto page = office.open<MaintenancePage>("administrator");

  child<QPushButton>(*page, "checkComputer").click();
  office.shell().waitForJobs();

  auto& dialog = child<QDialog>(*page, "installation");
  EXPECT_TRUE(dialog.isVisible());
  const QStringList lines = child<DataTable>(dialog, "checks").asText().split(QLatin1Char('\n'));
  ASSERT_GT(lines.size(), 15);
  EXPECT_TRUE(lines[1].startsWith(QStringLiteral("does not work\tBackup\tno backup is known\tMake one")))
      << lines[1].toStdString();
  EXPECT_TRUE(office.failures.isEmpty()) << office.failures.join(QLatin1Char('\n')).toStdString();
}

TEST(MaintenancePage, SavesAReportForSupportWithNobodyInIt) {
  AdministratorDesk office;
  office.centre.addTrainees(3);
  auto page = office.open<MaintenancePage>("administrator");
  child<QPushButton>(*page, "checkComputer").click();
  office.shell().waitForJobs();
  auto& dialog = child<InstallationDialog>(*page, "installation");
  EXPECT_TRUE(child<QPushButton>(dialog, "supportReport").isEnabled());
  const fs::path file = office.centre.folder() / "support.json";

  Q_EMIT dialog.reportWanted(QString::fromStdString(file.string()));
  office.shell().waitForJobs();

  const std::string report = readFile(file);
  EXPECT_NE(report.find("\"name\": \"backup\""), std::string::npos) << report;
  for (const std::string& name :
       selectAll(office.centre.connection(), "SELECT full_name FROM person_identity", {}, readText)) {
    EXPECT_EQ(report.find(name), std::string::npos) << name;
  }
  EXPECT_TRUE(office.failures.isEmpty()) << office.failures.join(QLatin1Char('\n')).toStdString();
}

TEST(UsersPage, CreatesAccountsForTheWholeRosterAndShowsTheirPasswordsOnce) {
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
    QTimer::singleShot(0, [] {  // asks before closing immediately
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

TEST(AuditPage, ShowsTheNewestThousandFirstAndTheOthersOnRequest) {
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
  auto& more = child<QToolButton>(*page, "more");
  EXPECT_EQ(table.visibleRows(), 1'000);
  EXPECT_FALSE(more.isHidden());
  more.click();
  EXPECT_EQ(table.visibleRows(), 2'000);
  more.click();

  EXPECT_EQ(table.visibleRows(), all);
  EXPECT_TRUE(more.isHidden());
}

constexpr int kWhat = 4;
constexpr int kCode = 7;

int rowOf(const QTableView& view, int column, const QString& text) {
  for (int row = 0; row < view.model()->rowCount(); ++row) {
    if (view.model()->index(row, column).data().toString() == text) {
      return row;
    }
  }
  return -1;
}

TEST(AuditPage, DescribesActionsInWordsAndAlsoFindsThemByCode) {
  AdministratorDesk office;
  office.centre.as("administrator");
  addPerson(office.centre.session(), {.fullName = "Li Na"});
  setRetentionRule(office.centre.session(), kRetainTrainee, 30, "contract");
  auto page = office.open<AuditPage>("administrator");
  auto& table = *page->findChild<DataTable*>();
  const int all = table.visibleRows();
  ASSERT_GE(all, 2);
  const int added = rowOf(table.view(), kWhat, QStringLiteral("Person entered"));
  ASSERT_GE(added, 0);
  EXPECT_EQ(table.view().model()->index(added, kWhat).data(Qt::ToolTipRole).toString(),
            QStringLiteral("person.add"));
  EXPECT_TRUE(table.view().isColumnHidden(kCode));
  EXPECT_FALSE(table.asText().contains(QStringLiteral("person.add")));

  QTest::keyClicks(&table.filter(), QStringLiteral("retention.rule"));

  ASSERT_EQ(table.visibleRows(), 1);
  table.view().selectRow(0);
  const QString entry = page->findChild<QPlainTextEdit*>()->toPlainText();
  EXPECT_TRUE(entry.contains(QStringLiteral("Rule for keeping records changed (retention.rule)")))
      << entry.toStdString();
  EXPECT_TRUE(entry.contains(QStringLiteral("rule for keeping records (retention_rule)")));
  table.filter().setText(QStringLiteral("person entered"));
  EXPECT_EQ(table.visibleRows(), 1);
  table.setColumnHidden(kCode, false);
  EXPECT_TRUE(table.asText().contains(QStringLiteral("person.add")));
}

TEST(AuditPage, FindsAPersonByCodeAndExportsAChosenPeriod) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(30);
  office.centre.runPaperCurriculum();
  auto page = office.open<AuditPage>("administrator");
  auto& table = *page->findChild<DataTable*>();

  QTest::keyClicks(&table.filter(), QStringLiteral("T-17"));

  ASSERT_EQ(table.visibleRows(), 1) << table.asText().toStdString();
  EXPECT_TRUE(table.asText().contains(QStringLiteral("person T-17")));
  table.filter().clear();
  const std::filesystem::path file = office.centre.folder() / "trail.csv";
  ASSERT_TRUE(page->exportTo(file));
  const CsvTable exported = CsvTable::read(
      file, {"sequence", "action", "object", "actor", "at_utc"},
      {"actor_id", "station", "object_kind", "object_id", "before", "after", "reason", "entry_hash"});
  const std::vector<AuditEntry> acts =
      AuditRepository(office.centre.connection()).entries({.limit = 1'000'000});
  EXPECT_EQ(exported.cell(exported.rows() - 1, "sequence"), std::to_string(acts.back().sequence));
  EXPECT_EQ(office.centre.audited("audit.export"), 1);

  // Two days without events: this centre's clock is in 2025.
  auto& span = child<QComboBox>(*page, "span");
  span.setCurrentIndex(span.findData(-1));
  child<QDateEdit>(*page, "from").setDate(QDate(2025, 1, 1));
  child<QDateEdit>(*page, "to").setDate(QDate(2025, 1, 2));
  EXPECT_EQ(table.visibleRows(), 0);
  child<QDateEdit>(*page, "to").setDate(QDate(2025, 12, 31));
  EXPECT_GE(table.visibleRows(), 30);
}

TEST(AuditPage, ShowsTheNewestThousandAndTheTotalNumber) {
  AdministratorDesk office;
  office.centre.as("administrator");
  const NewAuditEntry one{.atUtc_us = office.centre.session().now_us(),
                          .actor = "u",
                          .station = "s",
                          .action = AuditAction::kPersonAdd,
                          .objectKind = AuditObject::kPerson};
  AuditRepository audit(office.centre.connection());
  audit.append(std::vector<NewAuditEntry>(2'500, one));
  const std::int64_t newest = audit.length();
  auto page = office.open<AuditPage>("administrator");
  auto& table = *page->findChild<DataTable*>();
  auto& more = child<QToolButton>(*page, "more");
  const auto total = static_cast<qlonglong>(audit.count(0));
  EXPECT_EQ(table.visibleRows(), 1'000);
  EXPECT_EQ(table.view().model()->index(0, 0).data().toString(),
            page->locale().toString(static_cast<qlonglong>(newest)));
  EXPECT_TRUE(more.text().contains(page->locale().toString(total))) << more.text().toStdString();

  more.click();
  EXPECT_EQ(table.visibleRows(), 2'000);
  more.click();

  EXPECT_EQ(table.visibleRows(), static_cast<int>(total));
  EXPECT_TRUE(more.isHidden());
}

TEST(MaintenancePage, SortsTheQueueByTimeAlthoughTimesAreOnlyFormattedWhenDisplayed) {
  AdministratorDesk office;
  office.centre.as("administrator");
  setRetentionRule(office.centre.session(), kRetainTrainee, 1, "contract");
  for (int i = 0; i < 12; ++i) {
    addPerson(office.centre.session(), {.fullName = "Li Na"});
    office.centre.passTime_us(kDay_us);
  }
  office.centre.passTime_us(kDay_us);
  auto page = office.open<MaintenancePage>("administrator");
  QTableView& view = child<DataTable>(*page, "queue").view();
  ASSERT_EQ(child<DataTable>(*page, "queue").visibleRows(), 12);
  constexpr int kDueSince = 4;

  view.sortByColumn(kDueSince, Qt::DescendingOrder);

  // The person entered last has the highest code.
  EXPECT_GT(view.model()->index(0, 0).data().toString(), view.model()->index(11, 0).data().toString());
  const QString when = view.model()->index(0, kDueSince).data().toString();
  EXPECT_FALSE(when.isEmpty());
  child<DataTable>(*page, "queue").filter().setText(when);
  EXPECT_GE(child<DataTable>(*page, "queue").visibleRows(), 1);
}

TEST(RosterPage, ShowsNamesImmediately) {
  AdministratorDesk office;
  office.centre.addTrainees(3);
  auto page = office.open<RosterPage>("administrator");
  page->show();
  QApplication::processEvents();
  const QTableView& view = child<DataTable>(*page, "table").view();
  ASSERT_TRUE(view.isColumnHidden(1));

  page->findChild<QCheckBox*>()->click();
  QApplication::processEvents();

  ASSERT_FALSE(view.isColumnHidden(1));
  const QModelIndex name = view.model()->index(0, 1);
  EXPECT_TRUE(name.data().toString().startsWith(QStringLiteral("Trainee")));
  EXPECT_GE(view.columnWidth(1), view.fontMetrics().horizontalAdvance(name.data().toString()));
  EXPECT_TRUE(view.viewport()->rect().contains(view.visualRect(name)));
}

TEST(RightsOfTheWindow, StayAsReadWhileServicesCheckAgain) {
  AdministratorDesk office;
  SessionContext& session = office.centre.as("administrator");
  ASSERT_TRUE(office.shell().may(Operation::kUserManage));

  office.centre.connection().execute("DELETE FROM role_operation WHERE operation_code = ?",
                                     {std::string(operationCode(Operation::kUserManage))});

  EXPECT_TRUE(office.shell().may(Operation::kUserManage));
  EXPECT_THROW(session.require(Operation::kUserManage), Error);
  office.shell().readRights();
  EXPECT_FALSE(office.shell().may(Operation::kUserManage));
}

TEST(RightsOfTheWindow, AreThoseOfTheSignedInUser) {
  AdministratorDesk office;
  office.centre.as("administrator");
  ASSERT_TRUE(office.shell().may(Operation::kUserManage));

  office.centre.as("statistician");

  EXPECT_FALSE(office.shell().may(Operation::kUserManage));
  EXPECT_TRUE(office.shell().may(Operation::kResultsCompute));
}

TEST(PageTable, ContainsEveryPageOnceWithAUniqueName) {
  std::set<PageId> ids;
  std::set<QString> texts;

  for (const PageGroup& group : allPages()) {
    for (const PageEntry& entry : group.pages) {
      EXPECT_TRUE(ids.insert(entry.id).second) << pageText(entry.id).toStdString();
      EXPECT_TRUE(texts.insert(pageText(entry.id)).second) << pageText(entry.id).toStdString();
      EXPECT_FALSE(pageTitle(entry.id).isEmpty());
    }
  }

  EXPECT_EQ(ids.size(), static_cast<std::size_t>(PageId::kDevices) + 1);  // last entry of the table
}

}  // namespace

}  // namespace torsio::gui
