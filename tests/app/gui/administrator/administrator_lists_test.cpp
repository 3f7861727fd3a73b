// SPDX-License-Identifier: GPL-3.0-or-later
// Long lists of administrators: what is displayed, found by the search, and remembered.

#include <set>

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QPlainTextEdit>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/station/audit_page.h"
#include "app/gui/administrator/station/maintenance_page.h"
#include "app/gui/base/page.h"
#include "app/gui/program/window_main.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/base/csv_table.h"
#include "app/services/maintenance/retention.h"
#include "app/services/people/people_service.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/people/retention.h"
#include "db/repository/base/audit_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui {

namespace {

using testing::AdministratorDesk;

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
  auto& more = *page->findChild<QToolButton*>(QStringLiteral("more"));
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

}  // namespace

namespace {

using testing::AdministratorDesk;

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
