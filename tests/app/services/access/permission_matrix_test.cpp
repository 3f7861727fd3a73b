// SPDX-License-Identifier: GPL-3.0-or-later
// Every role x every operation, tested by calling the services: roles without a row in role_operation are
// refused.
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/outputs/report/coded_tables.h"
#include "app/outputs/report/report_data.h"
#include "app/services/access/access_service.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/frozen_data.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "sim/core/error.h"
#include "tests/app/services/access/permission_calls.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/stored_rows.h"

namespace torsio {
namespace {

using namespace testing;

const std::vector<ServiceCall>& calls() {
  static const std::vector<ServiceCall> kCalls = [] {
    std::vector<ServiceCall> all;
    for (const auto& some : {administratorCalls(), studyCalls(), reportingCalls(), connectorCalls(),
                             reviewCalls(), trainingCalls()}) {
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return kCalls;
}

using Permissions = std::set<std::pair<std::string, std::string>>;

/// Returns whether the database permits the call to the role.
bool isOpen(const ServiceCall& call, const std::string& role, const Permissions& allowed) {
  const auto has = [&](Operation operation) {
    return allowed.contains({role, std::string(operationCode(operation))});
  };
  return has(call.operation) || (call.also && has(*call.also));
}

/// Returns whether permission was refused, rather than an unknown or foreign object reported.
bool refused(const ServiceCall& call, SessionContext& session, const std::filesystem::path& folder) {
  try {
    call.run(session, folder);
  } catch (const Error& error) {
    return error.code() == ErrorCode::kPermission && error.where() == operationCode(call.operation) &&
           error.happened() != "this belongs to somebody else";
  }
  return false;
}

TEST(PermissionMatrix, EveryOperationIsRequiredByAServiceThatIsCalledHere) {
  StudyCentre centre;
  std::set<std::string> covered;
  for (const ServiceCall& call : calls()) {
    covered.emplace(operationCode(call.operation));
  }

  for (const std::string& operation : storedOperations(centre.connection())) {
    EXPECT_TRUE(covered.contains(operation)) << operation;
  }
  EXPECT_EQ(covered.size(), kOperationCodes.size());
}

TEST(PermissionMatrix, AServiceThatRequiresNoRightCannotReachTheRecord) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");

  EXPECT_THROW((void)session.connection(), ContractError);
  EXPECT_THROW(session.require(Operation::kMarkSubmit), Error);
  EXPECT_THROW((void)session.connection(), ContractError);  // required but refused

  session.require(Operation::kUserManage);
  EXPECT_EQ(&session.connection(), &centre.connection());
  session.beginCall();
  EXPECT_THROW((void)session.connection(), ContractError);  // the previous call's right
}

TEST(PermissionMatrix, AnotherUsersRightOpensNothing) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  session.require(Operation::kUserManage);

  session.setActor({});

  EXPECT_THROW((void)session.connection(), ContractError);
}

TEST(PermissionMatrix, EveryRoleMayDoExactlyWhatTheDatabaseSays) {
  StudyCentre centre;
  const auto allowed = storedPermissions(centre.connection());

  for (const std::string& role : storedRoles(centre.connection())) {
    for (const ServiceCall& call : calls()) {
      EXPECT_EQ(refused(call, centre.as(role), centre.folder()), !isOpen(call, role, allowed))
          << role << " calls " << call.name << " (" << operationCode(call.operation) << ")";
    }
  }
}

/// A trainee scored by one chief; if assigned, the other chief has not submitted yet.
struct ScoredCase {
  StudyCentre centre;
  ReportRequest request;
  std::string rubric;

  explicit ScoredCase(std::size_t chiefs) {
    const auto raters = centre.addChiefs(chiefs);
    rubric = centre.addPaperRubric();
    request.cohortId =
        addCohort(centre.session(), {.name = "Study", .curriculumVersionId = centre.runPaperCurriculum()});
    enrolTrainees(centre.session(), request.cohortId, centre.addTrainees(3));
    centre.allocate(request.cohortId);
    createAssignments(centre.as("administrator"), {.cohortId = request.cohortId,
                                                   .occasionCodes = {"pre"},
                                                   .raterIds = raters,
                                                   .rubricRevisionId = rubric,
                                                   .seed = 3});
    submit(raters.front());
  }
  void submit(const RaterId& raterId) {
    SheetRepository sheets(centre.connection());
    const RubricRevision revision = RubricRepository(centre.connection()).revision(rubric).value();
    for (const Assignment& one : sheets.assignmentsOf(raterId)) {
      const Sheet sheet = evenSheet(revision, 70, 70);
      sheets.submit(one.id, centre.session().ids().newUuid(), sheet, "", centre.session().now_us());
    }
  }
  bool sees(const std::string& role) {
    TrialDigests digests(centre.assets());
    return reportInputs(centre.as(role), request, digests).singleMarks;
  }
  void freeze() {
    request.frozenId =
        freezeData(centre.as("administrator"), request.cohortId, "frozen", {}, "a first look").id;
  }
};

TEST(PermissionMatrix, AnAdministratorsReportHasSingleMarksOnlyOnceTheyCannotBeInfluenced) {
  ScoredCase scored(1);
  EXPECT_TRUE(scored.sees("statistician"));
  EXPECT_FALSE(scored.sees("administrator"));  // not frozen

  scored.freeze();
  EXPECT_TRUE(scored.sees("administrator"));
  EXPECT_THROW(exportMarks(scored.centre.as("administrator"), scored.request.cohortId,
                           scored.centre.folder() / "marks.csv"),
               Error);
  scored.request.identity = ReportIdentity::kNamed;
  EXPECT_FALSE(scored.sees("administrator"));  // with names
  scored.request.identity = ReportIdentity::kCoded;
  reportDeviation(scored.centre.as("administrator"),
                  {.cohortId = scored.request.cohortId, .kind = "late", .description = "by ten minutes"});
  EXPECT_FALSE(scored.sees("administrator"));  // changed since the freeze
}

TEST(PermissionMatrix, AnAdministratorsReportHasNoSingleMarksWhileASheetIsMissing) {
  ScoredCase scored(2);

  scored.freeze();

  EXPECT_FALSE(scored.sees("administrator"));
  EXPECT_TRUE(scored.sees("statistician"));
}

TEST(PermissionMatrix, ARefusedCallDoesNotChangeTheRecord) {
  StudyCentre centre;
  const auto allowed = storedPermissions(centre.connection());
  const auto before = centre.rowCounts();

  for (const std::string& role : storedRoles(centre.connection())) {
    for (const ServiceCall& call : calls()) {
      if (isOpen(call, role, allowed)) {
        continue;
      }
      (void)refused(call, centre.as(role), centre.folder());
      ASSERT_EQ(centre.rowCounts(), before) << role << " calls " << call.name;
    }
  }
  for (const auto& entry : std::filesystem::directory_iterator(centre.folder())) {
    EXPECT_TRUE(entry.path().filename().string().starts_with("centre.sqlite")) << entry.path();
  }
}

TEST(PermissionMatrix, UnknownDisabledAndPracticeOnlyUsersAreRefusedEverything) {
  StudyCentre centre;
  const std::string administrator = centre.as("administrator").actor().userId;
  const std::string allocator = centre.as("allocator").actor().userId;
  setUserActive(centre.as("administrator"), allocator, false, "left");
  const Actor nobody;
  const Actor unknown{"00000000-0000-4000-8000-000000000000", "ghost", "", {"administrator"}, false};
  const Actor disabled{allocator, "allocator", "", {"allocator"}, false};
  const Actor practiceOnly{administrator, "administrator", "", {"administrator"}, true};
  const auto before = centre.rowCounts();

  for (const Actor& actor : {nobody, unknown, disabled, practiceOnly}) {
    for (const ServiceCall& call : calls()) {
      if (actor.practiceOnly && call.operation == Operation::kPractice) {
        continue;  // everything that a PIN permits
      }
      SessionContext& session = centre.session();
      session.setActor(actor);
      EXPECT_TRUE(refused(call, session, centre.folder())) << actor.login << " calls " << call.name;
    }
  }
  EXPECT_EQ(centre.rowCounts(), before);
}

TEST(PermissionMatrix, ClaimedRolesAreIgnored) {
  StudyCentre centre;
  Actor actor = centre.as("trainee").actor();
  actor.roles = {"administrator", "allocator"};
  centre.session().setActor(actor);

  EXPECT_THROW((void)users(centre.session()), Error);
  EXPECT_THROW((void)previewBalance(centre.session(), {}), Error);
}

TEST(PermissionMatrix, OnlyTheAdministratorLogsTimeOfOthers) {
  StudyCentre centre;
  const std::string person = centre.addTrainees(2).front();
  const CohortId cohort = addCohort(centre.session(), {.name = "C", .groups = {{"G1", "one"}}});
  const std::string enrolment = enrolTrainees(centre.session(), cohort, {person}).front();
  const NewExposure minute{cohort, enrolment, "", ExposureKind::kVirtual, 0, 60'000'000};

  recordExposure(centre.as("administrator"), minute);
  EXPECT_THROW(recordExposure(centre.as("trainee"), minute), Error);  // another trainee
  Actor self = centre.as("trainee").actor();
  self.personId = person;
  centre.session().setActor(self);
  recordExposure(centre.session(), minute);
  EXPECT_THROW(recordExposure(centre.as("rater"), minute), Error);
  EXPECT_EQ(centre.audited("exposure.record"), 2);
}

}  // namespace
}  // namespace torsio
