// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/reminders.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <nlohmann/json.hpp>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/blinded_due.h"
#include "assessment/domain/rating/live_call.h"
#include "db/connection/connection.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/sheet_repository.h"

namespace torsio {

namespace {

/// Returns recipients by rater id, with the visible contact data.
std::map<RaterId, Reminder> addressees(SessionContext& session) {
  PeopleRepository people(session.connection());
  std::map<RaterId, Reminder> all;
  for (const Rater& rater : people.raters()) {
    Reminder& one = all[rater.person.id];
    one.raterId = rater.person.id;
    one.raterCode = rater.person.code;
  }
  if (session.may(Operation::kPersonViewIdentity)) {
    for (const Identity& identity : people.identities()) {
      if (const auto found = all.find(identity.personId.text()); found != all.end()) {
        found->second.name = identity.fullName;
        found->second.email = identity.email;
      }
    }
  }
  return all;
}

}  // namespace

std::vector<Reminder> reminders(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kStudySetup);
  Connection& connection = session.connection();
  std::map<std::pair<EnrolmentId, std::string>, LiveCall> calls;  // latest call of each case
  for (LiveCall& call : CallRepository(connection).calls(cohortId)) {
    if (!call.cancelled) {
      const std::pair key(call.enrolmentId, call.occasionCode);
      calls[key] = std::move(call);
    }
  }
  std::map<RaterId, Reminder> all = addressees(session);
  const std::vector<AssignmentStatus> assignments = SheetRepository(connection).assignments(cohortId);
  std::map<RaterId, BlindedDue> due;
  for (const AssignmentStatus& status : assignments) {
    if (!status.assignment.trialId.empty() && status.state != SheetState::kWithdrawn) {
      due[status.assignment.raterId].add(status.assignment.dueUtc_us);
    }
  }
  for (const AssignmentStatus& status : assignments) {
    const Assignment& one = status.assignment;
    if (status.state != SheetState::kOpen && status.state != SheetState::kDraft) {
      continue;
    }
    SheetAwaited awaited{.caseLabel = one.caseLabel, .live = one.trialId.empty(), .dueUtc_us = one.dueUtc_us};
    if (awaited.live) {
      const auto call = calls.find({one.enrolmentId, one.occasionCode});
      if (call == calls.end()) {
        continue;  // cannot be scored yet
      }
      awaited.calledUtc_us = call->second.calledUtc_us;
      awaited.late = call->second.endedUtc_us.has_value();
    } else {
      awaited.dueUtc_us = due[one.raterId].latest();
      awaited.late = awaited.dueUtc_us && *awaited.dueUtc_us < session.now_us();
    }
    all[one.raterId].sheets.push_back(std::move(awaited));
  }
  std::vector<Reminder> owed;
  for (auto& [rater, reminder] : all) {
    if (reminder.sheets.empty()) {
      continue;
    }
    std::sort(reminder.sheets.begin(), reminder.sheets.end(),
              [](const SheetAwaited& a, const SheetAwaited& b) {
                return std::tuple(!a.late, a.caseLabel) < std::tuple(!b.late, b.caseLabel);
              });
    owed.push_back(std::move(reminder));
  }
  std::sort(owed.begin(), owed.end(),
            [](const Reminder& a, const Reminder& b) { return a.raterCode < b.raterCode; });
  return owed;
}

void noteReminders(SessionContext& session, std::span<const Reminder> reminded, ReminderWay way) {
  session.require(Operation::kStudySetup);
  Transaction transaction(session.connection());
  for (const Reminder& one : reminded) {
    nlohmann::json cases = nlohmann::json::array();
    for (const SheetAwaited& sheet : one.sheets) {
      cases.push_back(sheet.caseLabel);
    }
    session.note(way == ReminderWay::kMail ? AuditAction::kReminderMail : AuditAction::kReminderCopy,
                 AuditObject::kPerson, one.raterId.text(), {{"cases", std::move(cases)}});
  }
  transaction.commit();
}

}  // namespace torsio
