// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/sheet.h"
#include "sim/scene/scene.h"
#include "tests/app/support/test_record.h"

namespace torsio {

inline constexpr std::int64_t kReviewTime_us = kRecordTime_us;
inline constexpr std::int64_t kReviewDay_us = 86'400'000'000;

/// A centre with physicians who score, in a temporary SQLite file by default: named trainees in named groups,
/// each with a recording at the occasion "mid" and a live case at "post"; the rubric has the rows "time" and
/// "accuracy" (1 to 10 in tenths) and an overall mark.
class ReviewCentre : public TestRecord {
 public:
  struct Setup {
    int raters = 2;
    int trainees = 2;
    double trial_s = 2.0;
    bool live = false;                               ///< include the live cases
    std::vector<std::string> liveOccasions{"post"};  ///< with "mid", the recordings are not scored
    bool dueByTrainee = false;  ///< each trainee's cases have a separate deadline, days 1, 2 ...
    bool called = true;         ///< all live cases were called to the real arm
    /// Of the recordings; null: the bar of the servo tests (which no file describes).
    const Scene* scene = nullptr;
    std::string locator{};  ///< empty: an SQLite file in folder()
  };
  explicit ReviewCentre(const Setup& setup);
  /// Opens an existing centre in `folder`, like another program.
  explicit ReviewCentre(const std::filesystem::path& folder);

  /// Calls every live case to the real arm and ends the call, one per minute.
  void callAll();
  /// Signs in physician `index` (0 ..) in a separate session on the shared connection.
  [[nodiscard]] std::unique_ptr<SessionContext> physician(std::size_t index);
  [[nodiscard]] std::unique_ptr<SessionContext> administrator();
  /// Returns the assignments of physician `index` in the rater's order: recorded or live ones.
  [[nodiscard]] std::vector<AssignmentId> cases(std::size_t index, bool live = false);
  /// Returns the assignment of physician `index` for trainee `trainee`.
  [[nodiscard]] AssignmentId caseAbout(std::size_t index, std::size_t trainee);
  [[nodiscard]] const std::vector<TrialId>& trialIds() const { return trialIds_; }
  [[nodiscard]] const RubricRevisionId& rubricRevisionId() const { return rubricRevisionId_; }
  [[nodiscard]] RaterId raterId(std::size_t index);
  [[nodiscard]] CohortId cohortId();
  /// Adds the evaluation "campaign" of two models, PM under the letter K and FEM under M, with one of the
  /// recordings each if `recorded`. Physician i has the models in the order `orders[i]`.
  void addTwoModels(bool recorded, const std::vector<std::string>& orders = {"FEM,PM"});
  /// Returns everything that raters must not see: names, pseudonyms, groups, stages, phases, trial ids.
  [[nodiscard]] std::vector<std::string> secrets();

 private:
  void addPeople(const Setup& setup);
  void addTrials(const Setup& setup);
  void addAssignments(const Setup& setup);

  std::vector<EnrolmentId> enrolmentIds_;
  std::vector<std::string> traineeCodes_;
  std::vector<TrialId> trialIds_;
  RubricRevisionId rubricRevisionId_;
};

/// Fills in a sheet of the centre's rubric: both rows and the overall mark, points.
[[nodiscard]] Sheet reviewSheet(double time, double accuracy, double overall);
/// The same as a change of this sealed version.
[[nodiscard]] Sheet changedSheet(std::int64_t version, double time, double accuracy, double overall);

}  // namespace torsio

namespace torsio::testing {
using torsio::changedSheet;
using torsio::kReviewDay_us;
using torsio::kReviewTime_us;
using torsio::ReviewCentre;
using torsio::reviewSheet;
}  // namespace torsio::testing
