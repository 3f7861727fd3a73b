// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/rating/sheet_state.h"
#include "db/connection/connection.h"

namespace torsio {

/// Who is asked to judge what, the sheets while they are written, and their sealing. One call, one
/// transaction.
class SheetRepository {
 public:
  explicit SheetRepository(Connection& connection) : connection_(connection) {}

  void assign(std::span<const Assignment> assignments);
  /// Of a cohort, withdrawn ones too, by occasion, trainee, rater.
  [[nodiscard]] std::vector<AssignmentStatus> assignments(const CohortId& cohortId) const;
  /// Of one rater in any cohort, withdrawn ones too.
  [[nodiscard]] std::vector<Assignment> assignmentsOf(const RaterId& raterId) const;
  [[nodiscard]] std::optional<AssignmentStatus> findAssignment(const AssignmentId& assignmentId) const;
  /// Takes a sheet from its rater; what was typed waits. Throws Error (kBadData) when it was submitted or
  /// withdrawn already.
  void withdraw(const AssignmentId& assignmentId, const std::string& reason, const std::string& withdrawnBy,
                std::int64_t utc_us);
  /// The rater has the sheet again, under its old label. Throws Error (kBadData) when it was not withdrawn.
  void giveBack(const AssignmentId& assignmentId, const std::string& reason, const std::string& decidedBy,
                std::int64_t utc_us);
  /// In the rater's own order, without the withdrawn ones.
  [[nodiscard]] std::vector<QueueEntry> queue(const RaterId& raterId) const;

  /// `sheet.revision` is the one that was read. Returns the new one. Throws DbError (kConflict) when the
  /// draft was saved elsewhere in between, Error (kBadData) when the sheet was submitted or withdrawn.
  std::int64_t saveDraft(const AssignmentId& assignmentId, const Sheet& sheet);
  [[nodiscard]] std::optional<Sheet> draft(const AssignmentId& assignmentId) const;

  /// Seals the first version, or with `amendReason` the next one, as mark `markId` with its rows, and removes
  /// the draft. Throws Error (kBadData) when a row of the rubric is missing or unknown, or a score lies
  /// outside its scale; DbError (kUnique) when another station sealed it first. A repetition is no error.
  void submit(const AssignmentId& assignmentId, const MarkId& markId, const Sheet& sheet,
              const std::string& amendReason, std::int64_t submittedUtc_us);
  /// The newest sealed version; empty: not submitted.
  [[nodiscard]] std::optional<Sheet> submitted(const AssignmentId& assignmentId) const;

  /// Whether every rater who is asked about this case has submitted: until then each sees only their own
  /// sheet.
  [[nodiscard]] bool allSubmitted(const EnrolmentId& enrolmentId, const std::string& occasionCode) const;
  /// Since when a panel of two or more has committed on a case, so that each may see the marks of the others;
  /// empty: not yet, or there are no others.
  [[nodiscard]] std::optional<std::int64_t> panelOpenedUtc_us(const EnrolmentId& enrolmentId,
                                                              const std::string& occasionCode) const;

  /// Cohorts in which somebody was called to the real arm in [from, to), or stands there, or in which sheets
  /// that are asked for should be in by `to`.
  [[nodiscard]] std::vector<CohortId> cohortsAwaited(std::int64_t fromUtc_us, std::int64_t toUtc_us) const;
  /// Sheets of a cohort that somebody is asked for and has not submitted.
  [[nodiscard]] std::int64_t openAssignments(const CohortId& cohortId) const;

  void setReleased(const CohortId& cohortId, const std::string& occasionCode, bool released,
                   const std::string& reason, const std::string& decidedBy, std::int64_t utc_us);
  [[nodiscard]] bool isReleased(const CohortId& cohortId, const std::string& occasionCode) const;

 private:
  [[nodiscard]] SheetState stateOf(const AssignmentId& assignmentId) const;
  void decide(const AssignmentId& assignmentId, bool withdrawn, const std::string& reason,
              const std::string& decidedBy, std::int64_t utc_us);
  Connection& connection_;
};

}  // namespace torsio
