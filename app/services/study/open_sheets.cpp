// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/open_sheets.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/services/study/draw_field.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "sim/core/error.h"

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

namespace {

constexpr std::uint64_t kLabelOfOne = 1;  // random stream

AssignmentStatus statusOfSheet(SheetRepository& sheets, const AssignmentId& assignmentId) {
  const std::optional<AssignmentStatus> found = sheets.findAssignment(assignmentId);
  if (!found) {
    refuse(Text::tr("there is no such sheet"), assignmentId, Text::tr("Read the matrix again"));
  }
  return *found;
}

void requireActiveRater(SessionContext& session, const RaterId& raterId) {
  const std::vector<Rater> raters = PeopleRepository(session.connection()).raters();
  if (std::none_of(raters.begin(), raters.end(), [&](const Rater& rater) {
        return rater.person.id == raterId && rater.person.state == PersonState::kActive;
      })) {
    refuse(Text::tr("not an active rater"), raterId, Text::tr("Choose one from the list"));
  }
}

/// Returns the present or former sheet of a rater for the same case.
std::optional<AssignmentStatus> sheetAboutCase(SheetRepository& sheets, const RaterId& raterId,
                                               const Assignment& of) {
  for (const Assignment& own : sheets.assignmentsOf(raterId)) {
    if (own.enrolmentId == of.enrolmentId && own.occasionCode == of.occasionCode) {
      return sheets.findAssignment(own.id);
    }
  }
  return std::nullopt;
}

/// Assigns a new sheet to a rater who never had one for this case.
AssignmentId assignInstead(SessionContext& session, SheetRepository& sheets, Assignment next,
                           const RaterId& raterId) {
  std::set<std::string> labels;
  std::int64_t position = 0;
  for (const Assignment& other : sheets.assignmentsOf(raterId)) {
    labels.insert(other.caseLabel);
    position = std::max(position, other.position);
  }
  next.id = session.ids().newUuid();
  next.raterId = raterId;
  next.position = position + 1;
  // A live case keeps its label, which is called out in the room, unless the new rater uses it for another
  // case.
  if (!next.trialId.empty() || labels.contains(next.caseLabel)) {
    next.caseLabel = caseLabels(1, labels, drawSeed(session.ids()), kLabelOfOne).front();
  }
  next.assignedBy = session.actor().userId;
  next.assignedUtc_us = session.now_us();
  sheets.assign(std::span(&next, 1));
  return next.id;
}

AssignmentId moveSheet(SessionContext& session, const AssignmentStatus& before, const RaterId& newRaterId,
                       const std::string& reason) {
  SheetRepository sheets(session.connection());
  const Assignment& sheet = before.assignment;
  if (before.state == SheetState::kWithdrawn && newRaterId != sheet.raterId) {
    refuse(Text::tr("the sheet was withdrawn already"), sheet.caseLabel, Text::tr("Read the matrix again"));
  }
  if (before.state != SheetState::kWithdrawn) {
    sheets.withdraw(sheet.id, reason, session.actor().userId, session.now_us());
  }
  AssignmentId now;
  if (!newRaterId.empty()) {
    const std::optional<AssignmentStatus> own = sheetAboutCase(sheets, newRaterId, sheet);
    if (own && own->state != SheetState::kWithdrawn) {
      refuse(Text::tr("the other rater is asked about this case already"), own->assignment.caseLabel,
             Text::tr("Choose somebody else"));
    }
    if (own) {
      sheets.giveBack(own->assignment.id, reason, session.actor().userId, session.now_us());
    }
    now = own ? own->assignment.id : assignInstead(session, sheets, sheet, newRaterId);
  }
  session.noteChange(now.empty() ? AuditAction::kAssignmentWithdraw : AuditAction::kAssignmentReassign,
                     AuditObject::kAssignment, sheet.id, {{"rater", sheet.raterId}},
                     {{"rater", newRaterId}, {"assignment", now}}, reason);
  return now;
}

}  // namespace

SheetsMoved reassignAll(SessionContext& session, std::span<const AssignmentId> assignmentIds,
                        const RaterId& newRaterId, const std::string& reason) {
  session.require(Operation::kStudySetup);
  if (reason.empty()) {
    refuse(Text::tr("taking a sheet from its rater needs a reason"), Text::tr("sheets"), Text::tr("Say why"));
  }
  Transaction transaction(session.connection());
  if (!newRaterId.empty()) {
    requireActiveRater(session, newRaterId);
  }
  SheetRepository sheets(session.connection());
  SheetsMoved outcome;
  for (const AssignmentId& id : assignmentIds) {
    const AssignmentStatus before = statusOfSheet(sheets, id);
    if (before.state == SheetState::kSubmitted) {
      ++outcome.submitted;
      continue;
    }
    if (!newRaterId.empty()) {
      const std::optional<AssignmentStatus> own = sheetAboutCase(sheets, newRaterId, before.assignment);
      if (own && own->state != SheetState::kWithdrawn) {
        ++outcome.askedAlready;
        continue;
      }
    }
    static_cast<void>(moveSheet(session, before, newRaterId, reason));
    ++outcome.moved;
  }
  if (outcome.moved == 0) {
    refuse(Text::tr("none of these sheets can be moved (submitted: %1, asked already: %2)", outcome.submitted,
                    outcome.askedAlready),
           Text::tr("sheets"), Text::tr("Choose other sheets or another rater"));
  }
  transaction.commit();
  return outcome;
}

}  // namespace torsio
