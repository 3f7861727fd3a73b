// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/adjudicator.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/study/draw_field.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

using CaseKey = std::pair<std::string, std::string>;  // enrolment, occasion code

CaseKey keyOf(const Assignment& one) {
  return {one.enrolmentId, one.occasionCode};
}

/// Data about the sheets of one case.
struct CaseSheets {
  std::vector<AssignmentStatus> sheets;
  std::vector<DiscrepancyDecision> asked;  // oldest first
};

/// Returns the cases of a cohort for which an adjudicator was requested but not yet assigned.
std::map<CaseKey, CaseSheets> openCases(Connection& connection, const CohortId& cohortId) {
  std::map<std::string, DiscrepancyDecision> asked;
  for (DiscrepancyDecision& decision : DiscrepancyRepository(connection).ofCohort(cohortId)) {
    if (decision.choice == DiscrepancyChoice::kThird) {
      asked.emplace(decision.assignmentId, std::move(decision));
    }
  }
  std::map<CaseKey, CaseSheets> cases;
  if (asked.empty()) {
    return cases;
  }
  for (AssignmentStatus& status : SheetRepository(connection).assignments(cohortId)) {
    CaseSheets& one = cases[keyOf(status.assignment)];
    if (const auto found = asked.find(status.assignment.id); found != asked.end()) {
      one.asked.push_back(found->second);
    }
    one.sheets.push_back(std::move(status));
  }
  std::erase_if(cases, [](const auto& entry) {
    const CaseSheets& one = entry.second;
    const auto answered = [&one](const AssignmentStatus& status) {
      return status.state != SheetState::kWithdrawn &&
             std::all_of(one.asked.begin(), one.asked.end(), [&](const DiscrepancyDecision& decision) {
               return status.assignment.assignedUtc_us > decision.decidedUtc_us;
             });
    };
    return one.asked.empty() || std::any_of(one.sheets.begin(), one.sheets.end(), answered);
  });
  for (auto& [key, one] : cases) {
    std::sort(one.asked.begin(), one.asked.end(), [](const auto& a, const auto& b) {
      return std::pair(a.decidedUtc_us, a.assignmentId) < std::pair(b.decidedUtc_us, b.assignmentId);
    });
  }
  return cases;
}

const Assignment& assignmentOf(const CaseSheets& sheets, const std::string& id) {
  return std::find_if(sheets.sheets.begin(), sheets.sheets.end(),
                      [&id](const AssignmentStatus& status) { return status.assignment.id == id; })
      ->assignment;
}

/// Returns active raters with their open sheets, by id.
std::map<std::string, Adjudicator> activeRaters(Connection& connection) {
  std::map<std::string, Adjudicator> raters;
  SheetRepository sheets(connection);
  for (const Rater& rater : PeopleRepository(connection).raters()) {
    if (rater.person.state != PersonState::kActive) {
      continue;
    }
    Adjudicator one{rater.person.id, rater.person.code, rater.classCode, 0};
    for (const QueueEntry& entry : sheets.queue(one.id)) {
      one.open += entry.state != SheetState::kSubmitted;
    }
    raters.emplace(one.id, std::move(one));
  }
  return raters;
}

std::vector<Adjudicator> freeFor(const CaseSheets& sheets, const std::map<std::string, Adjudicator>& raters) {
  std::set<std::string> taken;
  for (const AssignmentStatus& status : sheets.sheets) {
    taken.insert(status.assignment.raterId);
  }
  const auto asker = raters.find(assignmentOf(sheets, sheets.asked.front().assignmentId).raterId);
  const std::string wanted = asker != raters.end() ? asker->second.classCode : std::string();
  std::vector<Adjudicator> free;
  for (const auto& [id, rater] : raters) {
    if (!taken.contains(id)) {
      free.push_back(rater);
    }
  }
  std::sort(free.begin(), free.end(), [&wanted](const Adjudicator& a, const Adjudicator& b) {
    const bool otherA = a.classCode != wanted;
    const bool otherB = b.classCode != wanted;
    return std::tie(otherA, a.open, a.code) < std::tie(otherB, b.open, b.code);
  });
  return free;
}

}  // namespace

std::vector<AdjudicatorRequest> adjudicatorRequests(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kStudySetup);
  Connection& connection = session.connection();
  std::vector<AdjudicatorRequest> requests;
  const std::map<CaseKey, CaseSheets> cases = openCases(connection, cohortId);
  if (cases.empty()) {
    return requests;
  }
  const Occasions occasions = OccasionRepository(connection).all();
  std::map<std::string, std::string> trainees;
  for (const Enrolment& enrolment : StudyRepository(connection).enrolments(cohortId)) {
    trainees[enrolment.id] = enrolment.traineeCode;
  }
  std::map<std::string, std::string> codes;
  for (const Rater& rater : PeopleRepository(connection).raters()) {
    codes[rater.person.id] = rater.person.code;
  }
  const std::map<std::string, Adjudicator> raters = activeRaters(connection);
  for (const auto& [key, sheets] : cases) {
    const Assignment& first = assignmentOf(sheets, sheets.asked.front().assignmentId);
    AdjudicatorRequest request;
    request.assignmentId = first.id;
    request.traineeCode = trainees[key.first];
    request.occasion = occasions.named(key.second);
    request.live = first.trialId.empty();
    for (const AssignmentStatus& status : sheets.sheets) {
      request.marks += status.state == SheetState::kSubmitted ? 1 : 0;
    }
    for (const DiscrepancyDecision& decision : sheets.asked) {
      request.askedBy.push_back(codes[assignmentOf(sheets, decision.assignmentId).raterId]);
      request.reasons.push_back(decision.reason);
    }
    request.askedUtc_us = sheets.asked.front().decidedUtc_us;
    request.free = freeFor(sheets, raters);
    requests.push_back(std::move(request));
  }
  std::stable_sort(
      requests.begin(), requests.end(),
      [](const AdjudicatorRequest& a, const AdjudicatorRequest& b) { return a.askedUtc_us < b.askedUtc_us; });
  return requests;
}

std::string assignAdjudicator(SessionContext& session, const CohortId& cohortId,
                              const AssignmentId& assignmentId, const RaterId& raterId) {
  session.require(Operation::kStudySetup);
  Transaction transaction(session.connection());
  SheetRepository sheets(session.connection());
  const auto asked = sheets.findAssignment(assignmentId);
  if (!asked) {
    refuse(Text::tr("nobody has asked for an adjudicator here"), assignmentId,
           Text::tr("Read the list again"));
  }
  const Assignment& before = asked->assignment;
  const std::map<CaseKey, CaseSheets> cases = openCases(session.connection(), cohortId);
  const auto found = cases.find(keyOf(before));
  if (found == cases.end()) {
    refuse(Text::tr("nobody has asked for an adjudicator here"), assignmentId,
           Text::tr("Read the list again"));
  }
  const std::vector<Adjudicator> free = freeFor(found->second, activeRaters(session.connection()));
  if (std::none_of(free.begin(), free.end(), [&](const Adjudicator& rater) { return rater.id == raterId; })) {
    refuse(Text::tr("this rater cannot be asked about this case"), assignmentId,
           Text::tr("Choose one from the list"));
  }
  Assignment next = before;
  std::set<std::string> labels;
  next.position = 0;
  for (const Assignment& other : sheets.assignmentsOf(raterId)) {
    labels.insert(other.caseLabel);
    next.position = std::max(next.position, other.position);
  }
  ++next.position;
  next.id = session.ids().newUuid();
  next.raterId = raterId;
  next.caseLabel = caseLabels(1, labels, drawSeed(session.ids()), 0).front();
  next.dueUtc_us.reset();
  next.assignedBy = session.actor().userId;
  next.assignedUtc_us = session.now_us();
  sheets.assign(std::span(&next, 1));
  session.note(AuditAction::kAssignmentAdjudicator, AuditObject::kAssignment, next.id,
               {{"rater", raterId}, {"asked_in", before.id}}, found->second.asked.front().reason);
  transaction.commit();
  return next.id;
}

}  // namespace torsio
