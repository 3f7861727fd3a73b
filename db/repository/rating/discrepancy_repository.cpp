// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/discrepancy_repository.h"

#include "assessment/people/audit_entry.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"

namespace torsio {

namespace {

const std::string kDecisions =
    "SELECT d.assignment_id, d.sequence, d.decision, d.reason, d.decided_by, d.decided_utc_us"
    " FROM alignment_decision d";

DiscrepancyDecision decisionOf(RowReader& row) {
  return {row.text(), row.int64(), row.text(), row.text(), row.text(), row.int64()};
}

}  // namespace

std::int64_t DiscrepancyRepository::add(const DiscrepancyDecision& decision) {
  Transaction transaction(connection_);
  const std::optional<DiscrepancyDecision> before = latest(decision.assignmentId);
  const std::int64_t sequence = before ? before->sequence + 1 : 1;
  connection_.execute(insertInto("alignment_decision",
                                 "assignment_id, sequence, decision, reason, decided_by, decided_utc_us"),
                      {decision.assignmentId, sequence, decision.decision, decision.reason,
                       decision.decidedBy, decision.decidedUtc_us});
  AuditEntry entry;
  entry.atUtc_us = decision.decidedUtc_us;
  entry.actor = decision.decidedBy;
  entry.station = station_;
  entry.action = "alignment." + decision.decision;
  entry.objectKind = "assignment";
  entry.objectId = decision.assignmentId;
  entry.reason = decision.reason;
  AuditRepository(connection_).append(entry);
  transaction.commit();
  return sequence;
}

std::vector<DiscrepancyDecision> DiscrepancyRepository::history(const std::string& assignmentId) const {
  return selectAll(connection_, kDecisions + " WHERE d.assignment_id = ? ORDER BY d.sequence", {assignmentId},
                   decisionOf);
}

std::optional<DiscrepancyDecision> DiscrepancyRepository::latest(const std::string& assignmentId) const {
  const std::vector<DiscrepancyDecision> all = history(assignmentId);
  return all.empty() ? std::nullopt : std::optional(all.back());
}

std::vector<DiscrepancyDecision> DiscrepancyRepository::ofCohort(const std::string& cohortId) const {
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
