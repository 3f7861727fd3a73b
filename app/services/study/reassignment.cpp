// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/reassignment.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/services/study/draw_field.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/sheet_state.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "sim/core/error.h"

namespace torsio {

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
    refuse(Text::tr("this is no active rater"), raterId, Text::tr("Choose one from the list"));
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
