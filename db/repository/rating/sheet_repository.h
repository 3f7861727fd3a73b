// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/rating/sheet_state.h"
#include "assessment/scoring/instrument.h"
#include "db/connection/connection.h"

namespace torsio {

/// What a score of a row means, in words.
struct StoredAnchor {
  std::int64_t score_steps = 0;
  std::string meaning{};
};

/// One line of a rubric.
struct StoredRubricRow {
  std::string code{};  ///< "proficiency"
  std::string label{};
  ScoreScale scale{};
  std::vector<StoredAnchor> anchors{};
};

/// A rubric as it was at one time. Never changes once stored.
struct StoredRubricRevision {
  std::string id{};
  std::string rubricId{};
  std::int64_t number = 1;
  std::string note{};
  ScoreScale overall{};  ///< of the overall mark
  std::vector<StoredRubricRow> rows{};
  std::string createdBy{};
  std::int64_t createdUtc_us = 0;
};

/// One rater is asked for one sheet about one trainee at one scoring point.
struct StoredAssignment {
  std::string id{};
  std::string raterId{};
  std::string enrolmentId{};
  std::string occasionCode{};
  std::string trialId{};  ///< empty: live, on the real arm
  std::string rubricRevisionId{};
  std::string caseLabel{};    ///< all that the rater sees: "7F"
  std::int64_t position = 0;  ///< shuffled order of this rater
  std::optional<std::int64_t> dueUtc_us{};
  std::string assignedBy{};
  std::int64_t assignedUtc_us = 0;
  bool demonstration = false;
};

/// One line of a rater's queue: nothing in it tells who, which group or which stage.
struct QueueEntry {
  std::string assignmentId{};
  std::string caseLabel{};
  std::string trialId{};
  std::string rubricRevisionId{};
  std::optional<std::int64_t> dueUtc_us{};
  SheetState state = SheetState::kOpen;
  std::int64_t submittedUtc_us = 0;  ///< of the newest version; 0: not submitted
};

/// One row of a sheet: a score, or why there is none. Both empty: not answered yet (drafts only).
struct SheetRow {
  std::string code{};
  std::optional<std::int64_t> score_steps{};
  std::string notAssessableReason{};
};

/// What a rater has filled in.
struct Sheet {
  std::int64_t revision = 0;  ///< of the draft: counts the saves; 0: never saved
  std::optional<std::int64_t> overall_steps{};
  std::string notAssessableReason{};
  std::string comment{};
  std::vector<SheetRow> rows{};
  std::int64_t changedUtc_us = 0;
};

/// A rubric in a list.
struct StoredRubric {
  std::string id{};
  std::string name{};  ///< unique
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// An assignment and how far its sheet has come; no marks.
struct AssignmentStatus {
  StoredAssignment assignment{};
  SheetState state = SheetState::kOpen;
  std::int64_t changedUtc_us = 0;  ///< of the draft or the newest mark; 0: neither
};

/// Rubrics, who is asked to judge what, the sheets while they are written, and their sealing. One call, one
/// transaction.
class SheetRepository {
 public:
  explicit SheetRepository(Connection& connection) : connection_(connection) {}

  void addRubric(const std::string& id, const std::string& name, std::int64_t createdUtc_us,
                 bool demonstration);
  /// By name.
  [[nodiscard]] std::vector<StoredRubric> rubrics() const;
  void addRevision(const StoredRubricRevision& revision);
  [[nodiscard]] std::optional<StoredRubricRevision> revision(const std::string& revisionId) const;
  /// Ids of a rubric's revisions, oldest first.
  [[nodiscard]] std::vector<std::string> revisionIds(const std::string& rubricId) const;

  void assign(std::span<const StoredAssignment> assignments);
  /// Of a cohort, withdrawn ones too, by scoring point, trainee, rater.
  [[nodiscard]] std::vector<AssignmentStatus> assignments(const std::string& cohortId) const;
  /// Of one rater in any cohort, withdrawn ones too.
  [[nodiscard]] std::vector<StoredAssignment> assignmentsOf(const std::string& raterId) const;
  [[nodiscard]] std::optional<AssignmentStatus> findAssignment(const std::string& assignmentId) const;
  /// Throws Error (kBadData) when the sheet was submitted already.
  void withdraw(const std::string& assignmentId, const std::string& reason, const std::string& withdrawnBy,
                std::int64_t utc_us);
  /// In the rater's own order, without the withdrawn ones.
  [[nodiscard]] std::vector<QueueEntry> queue(const std::string& raterId) const;

  /// `sheet.revision` is the one that was read. Returns the new one. Throws DbError (kConflict) when the
  /// draft was saved elsewhere in between, Error (kBadData) when the sheet was submitted or withdrawn.
  std::int64_t saveDraft(const std::string& assignmentId, const Sheet& sheet);
  [[nodiscard]] std::optional<Sheet> draft(const std::string& assignmentId) const;

  /// Seals the first version, or with `amendReason` the next one, as mark `markId` with its rows, and removes
  /// the draft. Throws Error (kBadData) when a row of the rubric is missing or unknown, or a score lies
  /// outside its scale; DbError (kUnique) when another station sealed it first. The same again is no error.
  void submit(const std::string& assignmentId, const std::string& markId, const Sheet& sheet,
              const std::string& amendReason, std::int64_t submittedUtc_us);
  /// The newest sealed version; empty: not submitted.
  [[nodiscard]] std::optional<Sheet> submitted(const std::string& assignmentId) const;

  /// Whether every rater who is asked about this case has submitted: until then each sees only their own
  /// sheet.
  [[nodiscard]] bool allSubmitted(const std::string& enrolmentId, const std::string& occasionCode) const;

  /// Sheets of a cohort that somebody is asked for and has not submitted.
  [[nodiscard]] std::int64_t openAssignments(const std::string& cohortId) const;

  void setReleased(const std::string& cohortId, const std::string& occasionCode, bool released,
                   const std::string& reason, const std::string& decidedBy, std::int64_t utc_us);
  [[nodiscard]] bool isReleased(const std::string& cohortId, const std::string& occasionCode) const;

 private:
  [[nodiscard]] SheetState stateOf(const std::string& assignmentId) const;
  Connection& connection_;
};

}  // namespace torsio
