// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "assessment/scoring/instrument.h"
#include "db/connection/connection.h"
#include "db/repository/rating/assessment_run.h"

namespace torsio {

/// One row of the sheet behind a mark: a score on the scale of its rubric row, or why there is none.
struct StoredMarkRow {
  std::string rubricRevisionId{};
  std::string rowCode{};
  std::optional<std::int64_t> score_steps{};
  std::string notAssessableReason{};
  friend bool operator==(const StoredMarkRow&, const StoredMarkRow&) = default;
};

/// One submitted mark of the training study: one rater, one trainee, one scoring point. Sealed by the
/// database: a correction is a new version with a reason.
struct StoredTrainingMark {
  std::string id{};
  std::string enrolmentId{};
  std::string raterId{};
  std::string occasionCode{};  ///< "pre", "mid", "post"
  std::int64_t version = 1;
  std::string trialId{};                      ///< the recording that was judged; empty: live, on the real arm
  std::optional<std::int64_t> score_steps{};  ///< empty: not assessable, with a reason
  ScoreScale scale{.lo = 10, .hi = 100, .stepsPerPoint = 10};  ///< paper section 6: 1 to 10
  std::string notAssessableReason{};
  std::string comment{};
  std::string assignmentId{};         ///< the request that it answers; empty: entered without one
  std::vector<StoredMarkRow> rows{};  ///< written by submit(); read by SheetRepository::submitted()
  std::string amendReason{};          ///< from version 2 on
  std::int64_t submittedUtc_us = 0;
  bool demonstration = false;
  std::string traineeCode{};       ///< filled when read
  std::string raterCode{};         ///< filled when read
  std::string groupCode{};         ///< filled when read
  std::int64_t numberInGroup = 0;  ///< filled when read
};

/// A trainee's score at one scoring point: mean over the raters.
struct StoredTrainingResult {
  std::string enrolmentId{};
  std::string occasionCode{};
  double mean = 0.0;
  double variance = 0.0;  ///< between the raters, divisor n
  std::int64_t raterCount = 0;
  std::int64_t missingCount = 0;
  std::vector<std::string> flags{};
};

/// A group at one scoring point (paper Fig. 23), with both divisors.
struct StoredGroupResult {
  std::string groupId{};
  std::string occasionCode{};
  std::int64_t traineeCount = 0;
  double mean = 0.0;
  double varianceN = 0.0;
  std::optional<double> varianceNMinus1;
  std::vector<std::string> flags{};
};

struct StoredTrainingRun {
  AssessmentRun run{};
  std::vector<StoredTrainingResult> trainees{};
  std::vector<StoredGroupResult> groups{};
};

/// Marks and results of the training study. One call, one transaction.
class RatingRepository {
 public:
  /// `station`: for the audit trail.
  explicit RatingRepository(Connection& connection, std::string station = {})
      : connection_(connection), station_(std::move(station)) {}

  /// Seals first versions and amendments alike, each with an entry in the audit trail. A mark that is stored
  /// already under its id with the same content is no error (a retry after a lost answer). Throws DbError:
  /// kUnique when this version exists (another station was faster: nothing is overwritten) or the id with
  /// other content, kCheck for a score outside its scale.
  void submit(std::span<const StoredTrainingMark> marks);
  /// The newest version of every mark of a cohort, ordered by scoring point, group, number, rater code.
  [[nodiscard]] std::vector<StoredTrainingMark> marks(const std::string& cohortId) const;
  /// All versions of one mark, oldest first.
  [[nodiscard]] std::vector<StoredTrainingMark> history(const std::string& enrolmentId,
                                                        const std::string& raterId,
                                                        const std::string& occasionCode) const;

  void storeRun(const std::string& cohortId, const StoredTrainingRun& run);

 private:
  Connection& connection_;
  std::string station_;
};

}  // namespace torsio
