// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/discrepancy_repository.h"

#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/stored_term.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

const std::string kDecisions =
    "SELECT d.assignment_id, d.sequence, d.decision, d.reason, d.decided_by, d.decided_utc_us"
    " FROM alignment_decision d";

DiscrepancyDecision decisionOf(RowReader& row) {
  return {.assignmentId = row.text(),
          .sequence = row.int64(),
          .choice = readTerm<DiscrepancyChoice>(row, "decision"),
          .reason = row.text(),
          .decidedBy = row.text(),
          .decidedUtc_us = row.int64()};
}

AuditAction actionOf(DiscrepancyChoice choice) {
  switch (choice) {
    case DiscrepancyChoice::kKeep:
      return AuditAction::kDiscrepancyKeep;
    case DiscrepancyChoice::kMove:
      return AuditAction::kDiscrepancyMove;
    case DiscrepancyChoice::kThird:
      return AuditAction::kDiscrepancyAdjudicator;
  }
  throw ContractError("no such decision");
}

}  // namespace

std::int64_t DiscrepancyRepository::add(const DiscrepancyDecision& decision) {
  Transaction transaction(connection_);
  const std::optional<DiscrepancyDecision> before = latest(decision.assignmentId);
  const std::int64_t sequence = before ? before->sequence + 1 : 1;
  connection_.execute(insertInto("alignment_decision",
                                 "assignment_id, sequence, decision, reason, decided_by, decided_utc_us"),
                      {decision.assignmentId, sequence, storedText(decision.choice), decision.reason,
                       decision.decidedBy, decision.decidedUtc_us});
  NewAuditEntry entry{.atUtc_us = decision.decidedUtc_us,
                      .actor = decision.decidedBy,
                      .station = station_,
                      .action = actionOf(decision.choice),
                      .objectKind = AuditObject::kAssignment,
                      .objectId = decision.assignmentId,
                      .reason = decision.reason};
  AuditRepository(connection_).append(entry);
  transaction.commit();
  return sequence;
}

std::vector<DiscrepancyDecision> DiscrepancyRepository::history(const AssignmentId& assignmentId) const {
  return selectAll(connection_, kDecisions + " WHERE d.assignment_id = ? ORDER BY d.sequence", {assignmentId},
                   decisionOf);
}

std::optional<DiscrepancyDecision> DiscrepancyRepository::latest(const AssignmentId& assignmentId) const {
  const std::vector<DiscrepancyDecision> all = history(assignmentId);
  return all.empty() ? std::nullopt : std::optional(all.back());
}

std::vector<DiscrepancyDecision> DiscrepancyRepository::ofCohort(const CohortId& cohortId) const {
  return selectAll(
      connection_,
      kDecisions +
          " JOIN assignment a ON a.id = d.assignment_id JOIN enrolment e ON e.id = a.enrolment_id"
          " WHERE e.cohort_id = ?"
          " AND NOT EXISTS (SELECT 1 FROM alignment_decision n WHERE n.assignment_id = d.assignment_id"
          " AND n.sequence > d.sequence) ORDER BY d.decided_utc_us, d.assignment_id",
      {cohortId}, decisionOf);
}

}  // namespace torsio
