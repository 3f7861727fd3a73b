// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/rating/sheet_check.h"
#include "db/connection/row_reader.h"

namespace torsio {

/// Assignments, draft sheets, and their submission. Each call is one transaction.
class SheetRepository {
 public:
  explicit SheetRepository(Connection& connection) : connection_(connection) {}

  void assign(std::span<const Assignment> assignments);
  /// Assignments of a cohort, including withdrawn ones, by occasion, trainee, rater.
  [[nodiscard]] std::vector<AssignmentStatus> assignments(const CohortId& cohortId) const;
  /// Assignments of one rater across cohorts, including withdrawn ones.
  [[nodiscard]] std::vector<Assignment> assignmentsOf(const RaterId& raterId) const;
  [[nodiscard]] std::optional<AssignmentStatus> findAssignment(const AssignmentId& assignmentId) const;
  /// Withdraws a sheet from its rater; the draft is kept. Throws Error (kBadData) if it was already submitted
  /// or withdrawn.
  void withdraw(const AssignmentId& assignmentId, const std::string& reason, const std::string& withdrawnBy,
                std::int64_t utc_us);
  /// Returns a withdrawn sheet to its rater under the old label. Throws Error (kBadData) if it was not
  /// withdrawn.
  void giveBack(const AssignmentId& assignmentId, const std::string& reason, const std::string& decidedBy,
                std::int64_t utc_us);
  /// Queue in the rater's own order, without withdrawn assignments.
  [[nodiscard]] std::vector<QueueEntry> queue(const RaterId& raterId) const;

  /// Saves a draft; `sheet.revision` is the revision read. Returns the new one. Throws DbError (kConflict) if
  /// the draft was saved elsewhere in between, Error (kBadData) if the sheet was submitted or withdrawn.
  std::int64_t saveDraft(const AssignmentId& assignmentId, const Sheet& sheet);
  [[nodiscard]] std::optional<Sheet> draft(const AssignmentId& assignmentId) const;

  /// Seals the first version or, with `amendReason`, the one after `sheet.revision` as mark `markId` with its
  /// rows, and deletes the draft. Throws Error (kBadData) if a row of the rubric is missing or unknown, or a
  /// score is off its scale; DbError if another station was first: kUnique for the first version, kConflict
  /// for an amendment of a version that is no longer the newest. Repeating the call is no error.
  void submit(const AssignmentId& assignmentId, const MarkId& markId, const Sheet& sheet,
              const std::string& amendReason, std::int64_t submittedUtc_us);
  /// The newest submitted version, its number as revision; empty: not submitted.
  [[nodiscard]] std::optional<Sheet> submitted(const AssignmentId& assignmentId) const;

  /// True if every rater assigned to this case has submitted; until then each sees only their own sheet.
  [[nodiscard]] bool allSubmitted(const EnrolmentId& enrolmentId, const std::string& occasionCode) const;
  /// When a panel of two or more had submitted completely, which opens the others' marks to each; empty: not
  /// yet, or no panel.
  [[nodiscard]] std::optional<std::int64_t> panelOpenedUtc_us(const EnrolmentId& enrolmentId,
                                                              const std::string& occasionCode) const;

  /// When a rater had first submitted every own sheet of this occasion in the cohort of the case: 0 without
  /// any; empty: not yet. Withdrawn sheets do not count.
  [[nodiscard]] std::optional<std::int64_t> ownSheetsDoneUtc_us(const EnrolmentId& enrolmentId,
                                                                const std::string& occasionCode,
                                                                const RaterId& raterId) const;

  /// Cohorts with a call to the real arm in [from, to) or still open, or with outstanding sheets due by `to`.
  [[nodiscard]] std::vector<CohortId> cohortsWithRaterWork(std::int64_t fromUtc_us,
                                                           std::int64_t toUtc_us) const;
  /// Number of assigned sheets of a cohort that are not submitted.
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

/// Returns "SELECT ... FROM assignment a" with the columns of readAssignment(), followed by `more`, which
/// starts with a comma or is empty.
[[nodiscard]] std::string selectAssignments(std::string_view more = {});

/// Returns the condition that the assignment `alias` is not withdrawn.
[[nodiscard]] std::string isAskedFor(std::string_view alias);

/// Reads the columns of selectAssignments().
[[nodiscard]] Assignment readAssignment(RowReader& row);

/// Reads the rows of a sheet, by code: of a draft or of a sealed mark. Throws DbError.
[[nodiscard]] std::vector<SheetRow> draftRows(Connection& connection, const AssignmentId& assignmentId);
[[nodiscard]] std::vector<SheetRow> markRows(Connection& connection, const MarkId& markId);

}  // namespace torsio
