// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/paper_sheets.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/study/day_board.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/sheet_check.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "sim/core/error.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

std::map<RaterId, std::string> raterCodes(Connection& connection) {
  std::map<RaterId, std::string> codes;
  for (const Rater& rater : PeopleRepository(connection).raters()) {
    codes[rater.person.id] = rater.person.code;
  }
  return codes;
}

bool isOpenLive(const AssignmentStatus& status) {
  return status.assignment.trialId.empty() &&
         (status.state == SheetState::kOpen || status.state == SheetState::kDraft);
}

Assignment openLiveSheet(Connection& connection, const AssignmentId& assignmentId) {
  const std::optional<AssignmentStatus> status = SheetRepository(connection).findAssignment(assignmentId);
  if (!status || !status->assignment.trialId.empty()) {
    refuse(Text::tr("there is no such sheet of the real arm"), assignmentId,
           Text::tr("Choose one from the list"));
  }
  const Text where = Text::tr("case %1", status->assignment.caseLabel);
  if (!isOpenLive(*status)) {
    refuse(Text::tr("this sheet is in already, or was withdrawn"), where, Text::tr("Read the list again"));
  }
  if (!CallRepository(connection)
           .wasCalled(status->assignment.enrolmentId, status->assignment.occasionCode)) {
    refuse(Text::tr("this case has not been called to the real arm yet"), where,
           Text::tr("Call the trainee on the page Today's sessions first"));
  }
  return status->assignment;
}

/// Returns the rows in which anybody else's typing differs, in sheet order.
std::vector<std::string> differing(const RubricRevision& rubric, const Sheet& own, const UserId& user,
                                   const std::vector<PaperEntry>& entries) {
  for (const PaperEntry& entry : entries) {
    if (entry.enteredBy != user) {
      return differencesOf(rubric, own, entry.sheet);
    }
  }
  return {};
}

Text namesOf(const RubricRevision& rubric, const std::vector<std::string>& codes) {
  std::vector<Text> names;
  for (const std::string& code : codes) {
    const auto row = std::find_if(rubric.rows.begin(), rubric.rows.end(),
                                  [&](const RubricLine& line) { return line.code == code; });
    names.push_back(row == rubric.rows.end() ? Text::tr("overall mark") : Text(row->label));
  }
  return listed(names);
}

}  // namespace

std::vector<PaperCase> paperCases(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kStudySetup);
  Connection& connection = session.connection();
  std::map<std::pair<EnrolmentId, std::string>, std::int64_t> called;
  for (const LiveCall& call : CallRepository(connection).calls(cohortId)) {
    if (!call.cancelled) {
      called[{call.enrolmentId, call.occasionCode}] = call.calledUtc_us;
    }
  }
  std::map<AssignmentId, std::vector<UserId>> typed;
  for (const PaperEntry& entry : PaperRepository(connection).ofCohort(cohortId)) {
    typed[entry.assignmentId].push_back(entry.enteredBy);
  }
  const std::map<RaterId, std::string> codes = raterCodes(connection);
  std::vector<PaperCase> cases;
  for (const AssignmentStatus& status : SheetRepository(connection).assignments(cohortId)) {
    const Assignment& one = status.assignment;
    const auto call = called.find({one.enrolmentId, one.occasionCode});
    if (!isOpenLive(status) || call == called.end()) {
      continue;
    }
    PaperCase shown{one.id, one.caseLabel, codes.at(one.raterId), call->second};
    for (const UserId& user : typed[one.id]) {
      (user == session.actor().userId ? shown.byMe = true : (++shown.byOthers, true));
    }
    shown.differs = typed[one.id].size() > 1;  // a sheet typed alike by two people is no longer listed here
    cases.push_back(std::move(shown));
  }
  std::sort(cases.begin(), cases.end(), [](const PaperCase& a, const PaperCase& b) {
    return std::tie(a.calledUtc_us, a.caseLabel, a.raterCode) <
           std::tie(b.calledUtc_us, b.caseLabel, b.raterCode);
  });
  return cases;
}

PaperForm paperForm(SessionContext& session, const AssignmentId& assignmentId) {
  session.require(Operation::kStudySetup);
  Connection& connection = session.connection();
  const Assignment assignment = openLiveSheet(connection, assignmentId);
  PaperForm form{.caseLabel = assignment.caseLabel,
                 .raterCode = raterCodes(connection).at(assignment.raterId),
                 .rubric = RubricRepository(connection).revision(assignment.rubricRevisionId).value()};
  const std::vector<PaperEntry> entries = PaperRepository(connection).of(assignmentId);
  for (const PaperEntry& entry : entries) {
    if (entry.enteredBy == session.actor().userId) {
      form.own = entry.sheet;
      form.differing = differing(form.rubric, form.own, entry.enteredBy, entries);
    }
  }
  return form;
}

PaperOutcome enterPaperSheet(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet) {
  session.require(Operation::kStudySetup);
  Connection& connection = session.connection();
  Transaction transaction(connection);
  const Assignment assignment = openLiveSheet(connection, assignmentId);
  SheetRepository sheets(connection);
  const RubricRevision rubric = RubricRepository(connection).revision(assignment.rubricRevisionId).value();
  const Text where = Text::tr("case %1", assignment.caseLabel);
  if (const std::vector<std::string> faults = faultyRows(rubric, sheet); !faults.empty()) {
    refuse(Text::tr("no mark of the scale and no reason: %1", namesOf(rubric, faults)), where,
           Text::tr("Type what is on the paper; if it says nothing, give that as the reason"));
  }
  PaperRepository paper(connection);
  const UserId user = session.actor().userId;
  paper.put({assignmentId, user, sheet, session.now_us()});
  bool others = false;
  for (const PaperEntry& entry : paper.of(assignmentId)) {
    if (entry.enteredBy == user) {
      continue;
    }
    others = true;
    if (!differencesOf(rubric, sheet, entry.sheet).empty()) {
      continue;
    }
    paper.remove(assignmentId);
    sheets.submit(assignmentId, session.ids().newUuid(), sheet, "", session.now_us());
    session.note(
        {.action = AuditAction::kSheetSubmit,
         .objectKind = AuditObject::kAssignment,
         .objectId = assignmentId,
         .newJson =
             nlohmann::json{{"paper", true}, {"typed_by", {entry.enteredBy.text(), user.text()}}}.dump()});
    transaction.commit();
    return PaperOutcome::kCounts;
  }
  transaction.commit();
  return others ? PaperOutcome::kDiffers : PaperOutcome::kFirst;
}

std::vector<PaperSheet> paperSheets(SessionContext& session, const CohortId& cohortId,
                                    const EnrolmentId& enrolmentId, const std::string& occasionCode) {
  session.require(Operation::kStudySetup);
  std::map<EnrolmentId, std::string> wanted;
  for (const DayBoardRow& row : dayBoard(session, cohortId).rows) {
    if (row.state != EnrolmentState::kWithdrawn && (enrolmentId.empty() || row.enrolmentId == enrolmentId)) {
      wanted[row.enrolmentId] = occasionCode.empty() ? row.occasionDue.code : occasionCode;
    }
  }
  Connection& connection = session.connection();
  SheetRepository repository(connection);
  const std::map<RaterId, std::string> codes = raterCodes(connection);
  std::map<RubricRevisionId, RubricRevision> rubrics;
  std::vector<PaperSheet> sheets;
  for (const AssignmentStatus& status : repository.assignments(cohortId)) {
    const Assignment& one = status.assignment;
    const auto asked = wanted.find(one.enrolmentId);
    if (!isOpenLive(status) || asked == wanted.end() || asked->second != one.occasionCode) {
      continue;
    }
    auto rubric = rubrics.find(one.rubricRevisionId);
    if (rubric == rubrics.end()) {
      rubric = rubrics
                   .emplace(one.rubricRevisionId,
                            RubricRepository(connection).revision(one.rubricRevisionId).value())
                   .first;
    }
    sheets.push_back({one.caseLabel, codes.at(one.raterId), rubric->second});
  }
  std::sort(sheets.begin(), sheets.end(), [](const PaperSheet& a, const PaperSheet& b) {
    return std::tie(a.caseLabel, a.raterCode) < std::tie(b.caseLabel, b.raterCode);
  });
  return sheets;
}

}  // namespace torsio
