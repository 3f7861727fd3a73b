// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "tests/app/support/test_record.h"

namespace torsio {

inline constexpr std::int64_t kStudyTime_us = kRecordTime_us;
/// Of every user here; long enough and without a known pattern.
inline constexpr const char* kStudyPassword = "four walls and a lamp";

/// A study of StudyCentre::addStudy().
struct PaperStudy {
  CohortId cohortId{};
  std::vector<TraineeId> trainees{};
  std::vector<EnrolmentId> enrolmentIds{};
  std::vector<RaterId> chiefs{};
  std::string rubric{};  ///< revision; empty without chiefs

  /// Asks every chief for a sheet of everybody before, during and after the training.
  [[nodiscard]] ScoringPlan plan(std::uint64_t seed = 3) const;
};

/// Returns a sheet with this overall mark and one mark in every row.
[[nodiscard]] Sheet evenSheet(const RubricRevision& rubric, std::int64_t overall_steps,
                              std::int64_t row_steps);

/// An empty centre in a temporary SQLite file, or at `locator`, with one user of each role ("administrator",
/// "allocator", "statistician", "rater", "trainee"), signed in as nobody.
class StudyCentre : public TestRecord {
 public:
  explicit StudyCentre(const std::string& locator = {});

  [[nodiscard]] SessionContext& session() {
    session_->beginCall();
    return *session_;
  }
  [[nodiscard]] static std::filesystem::path assets() {
    return std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  }
  /// Signs in the user of this role, or nobody for "".
  SessionContext& as(const std::string& role);
  /// Signs in the user "rater" as this rater of the record.
  SessionContext& asRater(const RaterId& raterId);

  /// Stores trainees T-01 .. with sex and level, and raters of the class "chief" R-01 ..; as the
  /// administrator.
  std::vector<TraineeId> addTrainees(std::size_t count);
  std::vector<RaterId> addChiefs(std::size_t count);
  /// Stores and runs the paper's curriculum. Returns the version.
  std::string runPaperCurriculum();
  /// Stores the shipped rubric. Returns the revision.
  std::string addPaperRubric();

  /// Stores the cohort "Study" with the paper's curriculum, new trainees, chiefs and, for these, the shipped
  /// rubric; as the administrator.
  PaperStudy addStudy(std::size_t trainees, std::size_t chiefs = 0);
  /// Draws the groups of everybody in the cohort; as the allocator.
  void allocate(const CohortId& cohortId);

  /// Returns the number of rows of every table, and the hash of the last audit entry: what a refused call
  /// must not change.
  [[nodiscard]] std::map<std::string, std::int64_t> rowCounts();
  [[nodiscard]] std::int64_t audited(const std::string& action);

 private:
  std::unique_ptr<SessionContext> session_ = sessionOf("test station", {});
};

}  // namespace torsio

namespace torsio::testing {
using torsio::kStudyPassword;
using torsio::kStudyTime_us;
using torsio::StudyCentre;
}  // namespace torsio::testing
