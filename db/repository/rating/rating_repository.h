// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/mark.h"
#include "db/connection/connection.h"
#include "db/repository/rating/assessment_run.h"

namespace torsio {

/// A trainee's score at one occasion: the mean over the raters.
struct TrainingResultRow {
  EnrolmentId enrolmentId{};
  std::string occasionCode{};
  double mean = 0.0;
  double variance = 0.0;  ///< between the raters, divisor n
  std::int64_t raterCount = 0;
  std::int64_t missingCount = 0;
  std::vector<std::string> flags{};
};

/// A group at one occasion (paper Fig. 23), with both divisors.
struct GroupResultRow {
  GroupId groupId{};
  std::string occasionCode{};
  std::int64_t traineeCount = 0;
  double mean = 0.0;
  double varianceN = 0.0;
  std::optional<double> varianceNMinus1;
  std::vector<std::string> flags{};
};

struct TrainingRunRows {
  AssessmentRun run{};
  std::vector<TrainingResultRow> trainees{};
  std::vector<GroupResultRow> groups{};
};

/// Marks and results of the training study. Each call is one transaction.
class RatingRepository {
 public:
  /// `station`: for the audit trail.
  explicit RatingRepository(Connection& connection, std::string station = {})
      : connection_(connection), station_(std::move(station)) {}

  /// Seals first versions and amendments, each with an entry in the audit trail. Submitting the same mark
  /// again is no error (a retry after a lost answer). Throws DbError: kUnique if this version exists (another
  /// station was faster; nothing is overwritten) or the id has other content, kCheck for a score off its
  /// scale.
  void submit(std::span<const SubmittedMark> marks);
  /// The newest version of every mark of a cohort, ordered by occasion, group, number, rater code.
  [[nodiscard]] std::vector<SubmittedMark> marks(const CohortId& cohortId) const;
  /// Scores by criterion of the sheets behind a cohort's marks, by mark, all versions.
  [[nodiscard]] std::map<MarkId, std::vector<MarkRow>> criteria(const CohortId& cohortId) const;
  /// All versions of one mark, oldest first.
  [[nodiscard]] std::vector<SubmittedMark> history(const EnrolmentId& enrolmentId, const RaterId& raterId,
                                                   const std::string& occasionCode) const;

  void storeRun(const CohortId& cohortId, const TrainingRunRows& run);

 private:
  Connection& connection_;
  std::string station_;
};

/// Decisions about marks that differ strongly. Append-only; the newest counts. Each is recorded in the audit
/// trail
/// in the same transaction.
class DiscrepancyRepository {
 public:
  /// `station`: for the audit trail.
  explicit DiscrepancyRepository(Connection& connection, std::string station = {})
      : connection_(connection), station_(std::move(station)) {}

  /// Returns the sequence number. Throws DbError: kForeignKey (no such assignment).
  std::int64_t add(const DiscrepancyDecision& decision);
  /// Oldest first.
  [[nodiscard]] std::vector<DiscrepancyDecision> history(const AssignmentId& assignmentId) const;
  [[nodiscard]] std::optional<DiscrepancyDecision> latest(const AssignmentId& assignmentId) const;
  /// True if a rater has decided on this case.
  [[nodiscard]] bool decidedBy(const EnrolmentId& enrolmentId, const std::string& occasionCode,
                               const RaterId& raterId) const;
  /// The newest decision of every assignment of a cohort, oldest first.
  [[nodiscard]] std::vector<DiscrepancyDecision> ofCohort(const CohortId& cohortId) const;

 private:
  Connection& connection_;
  std::string station_;
};

}  // namespace torsio
