// SPDX-License-Identifier: GPL-3.0-or-later
// Lists must open instantly however long the record is: no list query may scan or sort a table that grows
// over the years. Checks SQLite's plan of every statement that the repositories prepare.
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "assessment/domain/people/account.h"
#include "assessment/domain/people/retention.h"
#include "db/connection/connection.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/retention_repository.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/freeze_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/digest_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/station_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

class QueryPlanTest : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (onPostgresql()) {
      GTEST_SKIP() << "PostgreSQL plans by the size of its tables";
    }
  }

  static std::vector<std::string> plansOf(Connection& connection, const std::function<void()>& list) {
    std::vector<std::string> statements;
    connection.observeStatements([&](std::string_view sql) { statements.emplace_back(sql); });
    list();
    connection.observeStatements(nullptr);
    std::vector<std::string> lines;
    for (const std::string& sql : statements) {
      Statement plan = connection.prepare("EXPLAIN QUERY PLAN " + sql);
      plan.execute(std::vector<Value>(static_cast<std::size_t>(std::count(sql.begin(), sql.end(), '?'))));
      while (plan.step()) {
        lines.push_back(plan.text(3));
      }
    }
    return lines;
  }

  /// True for tables of the centre that stay short.
  static bool isOfShortList(const std::string& line) {
    return line.rfind("SCAN rater", 0) == 0 || line.rfind("SCAN occasion", 0) == 0;
  }
  /// `inOrder`: an index scan is intended, as the whole list is shown or LIMIT ends it.
  static void expectNoWalk(const std::vector<std::string>& lines, bool inOrder = false) {
    EXPECT_FALSE(lines.empty());
    for (const std::string& line : lines) {
      const bool walk = line.rfind("SCAN", 0) == 0 && line.find("CONSTANT ROW") == std::string::npos &&
                        !isOfShortList(line);
      EXPECT_FALSE(walk && !(inOrder && line.find("INDEX") != std::string::npos)) << line;
    }
  }
  static void expectNoSort(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      EXPECT_EQ(line.find("TEMP B-TREE"), std::string::npos) << line;
    }
  }
};

TEST_F(QueryPlanTest, TrialsUseAnIndexAndTheNewestNeedNoSorting) {
  TrialRepository trials(connection());
  const auto newest = plansOf(connection(), [&] { (void)trials.list(); });
  expectNoWalk(newest, true);
  expectNoSort(newest);
  expectNoWalk(plansOf(connection(), [&] { (void)trials.list({.traineeCode = "T-01"}); }));
  expectNoWalk(plansOf(connection(), [&] { (void)trials.list({.enrolmentId = "e"}); }));
  expectNoWalk(plansOf(connection(), [&] { (void)trials.unfinished("station"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)trials.find("t"); }));
}

TEST_F(QueryPlanTest, PeopleAreListedByAnIndex) {
  PeopleRepository people(connection());
  const auto trainees = plansOf(connection(), [&] { (void)people.trainees(); });
  expectNoWalk(trainees, true);
  expectNoSort(trainees);
  expectNoWalk(plansOf(connection(), [&] { (void)people.findTrainee("T-01"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)people.consents("p"); }));
}

TEST_F(QueryPlanTest, MarksOfACohortUseAnIndex) {
  expectNoWalk(plansOf(connection(), [&] { (void)StudyRepository(connection()).enrolments("c"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)StudyRepository(connection()).exposures("c"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)StudyRepository(connection()).deviations("c"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)RatingRepository(connection()).marks("c"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)SheetRepository(connection()).openAssignments("c"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)DigestRepository(connection()).ofCohort("c", 1); }));
  expectNoWalk(plansOf(connection(), [&] { (void)DigestRepository(connection()).ofTrial("t", 1); }));
  expectNoWalk(plansOf(connection(), [&] { (void)RatingRepository(connection()).history("e", "r", "pre"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)EvaluationRepository(connection()).marks("c"); }));
}

TEST_F(QueryPlanTest, ARatersQueueAndTheAuditTrailUseAnIndex) {
  SheetRepository sheets(connection());
  expectNoWalk(plansOf(connection(), [&] { (void)sheets.queue("r"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)sheets.allSubmitted("e", "pre"); }));
  expectNoWalk(plansOf(connection(), [&] {
    (void)AuditRepository(connection()).entries({.objectKind = AuditObject::kTrial});
  }));
  expectNoWalk(
      plansOf(connection(), [&] { (void)AuditRepository(connection()).entries({.fromUtc_us = 1}); }));
  for (int i = 0; i < 2; ++i) {
    AuditRepository(connection())
        .append({.atUtc_us = 5,
                 .actor = "a",
                 .station = "s",
                 .action = AuditAction::kTrialFinish,
                 .objectKind = AuditObject::kTrial});
  }
  const auto newest =
      plansOf(connection(), [&] { (void)AuditRepository(connection()).entries({.limit = 1}); });
  expectNoWalk(newest, true);  // LIMIT ends it
  expectNoSort(newest);
}

TEST_F(QueryPlanTest, AStationsStartAndTheBoardUseAnIndex) {
  TrialRepository trials(connection());
  expectNoWalk(plansOf(connection(), [&] { (void)trials.closeInterrupted("station", 0); }));
  expectNoWalk(plansOf(connection(), [&] { (void)trials.context("t"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)trials.list({.moduleId = "m"}); }));
  StationRepository stations(connection());
  const auto board = plansOf(connection(), [&] { (void)stations.board(); });
  expectNoWalk(board, true);  // one row per station
  expectNoSort(board);
}

TEST_F(QueryPlanTest, RemarksAndUnreadRemarksUseAnIndex) {
  RemarkRepository remarks(connection());
  expectNoWalk(plansOf(connection(), [&] { (void)remarks.remarks("t"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)remarks.earlierWordings("t"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)remarks.receipts("t"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)remarks.unreadOnTrialsOf("p", "r"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)remarks.unreadReplies("a"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)remarks.selfScores("t"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)remarks.calibrationScores("r"); }));
}

TEST_F(QueryPlanTest, ARatersDeskUsesAnIndex) {
  DeskRepository desk(connection());
  expectNoWalk(plansOf(connection(), [&] { (void)desk.assignment("a"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)desk.isWithdrawn("a"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)desk.marksOfCase("e", "pre"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)desk.committed("r"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)desk.trialLength_us("t"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)desk.draftViewing("a"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)desk.workingTimes_us("r", 20); }));
  expectNoWalk(plansOf(connection(), [&] { (void)desk.evaluationDraft("c", "r"); }));
  DiscrepancyRepository discrepancies(connection());
  expectNoWalk(plansOf(connection(), [&] { (void)discrepancies.history("a"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)discrepancies.latest("a"); }));
}

TEST_F(QueryPlanTest, AdministratorsListsUseAnIndex) {
  CurriculumRepository curricula(connection());
  expectNoWalk(plansOf(connection(), [&] { (void)curricula.draft("c"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)curricula.version("v"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)curricula.versionIds("c"); }));
  expectNoWalk(plansOf(connection(), [&] { (void)FreezeRepository(connection()).list("c"); }));
  RetentionRepository(connection()).setRule({kRetainTrainee, 1, "contract", 1});
  const auto due = plansOf(connection(), [&] { (void)RetentionRepository(connection()).due(1); });
  for (const std::string& line : due) {
    if (line.find(" m ") == std::string::npos) {
      continue;
    }
    EXPECT_NE(line.find("COVERING INDEX"), std::string::npos) << line;  // the marks themselves are not read
  }
  AccessRepository access(connection(), PasswordCost::kTest);
  expectNoWalk(plansOf(connection(), [&] { (void)access.allowed("u", "trial.view"); }));
}

}  // namespace
}  // namespace torsio
