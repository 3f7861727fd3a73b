// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <variant>
#include <vector>

#include "assessment/statistics/values.h"
#include "sim/core/text.h"

namespace torsio {

/// Part of a study that a result belongs to.
enum class ResultSection : std::uint8_t {
  kEvaluation,
  kTraining,
  kScoringSheet,
  kCriterion,
  kAgreement,
  kComparison,
  kTrial,
  kCompetence,
  kDeviation,
  kRecord,
  kParticipants,
  kPractice,  ///< times of training, learning curves
};

/// Returns "evaluation", "training" ..., the first column of cohort.csv.
[[nodiscard]] std::string_view sectionName(ResultSection section) noexcept;

/// Identifies one result of a cohort. Fields that do not apply are empty.
struct ResultKey {
  ResultSection section = ResultSection::kTraining;
  std::string statistic{};   ///< "score", "icc_2_1"
  std::string of{};          ///< trainee, rater, scoring sheet; empty: all
  std::string group{};       ///< name, with its number in the record: "Group 2"
  std::string against{};     ///< second group of a pairwise comparison
  std::string raterClass{};  ///< id
  std::string model{};      ///< tissue model; scoring sheet with revision and criterion code; program version
  std::string index{};      ///< of the instrument; rater of a mark; revision of a scoring sheet; exercise
  std::int64_t number = 0;  ///< of a twist, from 1
  std::string occasion{};   ///< name
  std::string when{};       ///< phase of a run, time of a deviation
  std::string record{};     ///< distinguishes equal names: recording, deviation, exercise, sheet

  friend auto operator<=>(const ResultKey&, const ResultKey&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Hashes all fields.
struct ResultKeyHash {
  std::size_t operator()(const ResultKey& key) const noexcept;
};

/// As `of` in a pattern, matches every single person or thing, but no summary.
inline constexpr const char* kEach = "*";

/// Matches keys with equal section, statistic and `of`, and equal values of its other non-empty fields.
using ResultPattern = ResultKey;
[[nodiscard]] bool matches(const ResultPattern& pattern, const ResultKey& key) noexcept;

enum class RecordKind : std::uint8_t {
  kMark,            ///< of the training study
  kEvaluationMark,  ///< of the evaluation of models
  kRecording,
  kRubricRevision,
  kCompetenceDesign,  ///< number of its version; 0: shipped with the exercise
  kDeviation,
  kEnrolments,     ///< of the cohort: who should be marked
  kTrainingTimes,  ///< of the cohort: the times noted for training and rest
  kSheetRequests,  ///< of the cohort: the sheets requested from raters
  kCampaign,       ///< the evaluation of models: who was assigned
  kCohortPlan,     ///< plan of the cohort
  kAuditTrail,
  kProgram,
};

/// A row of the record, or data that have no rows of their own.
struct RecordRef {
  RecordKind kind = RecordKind::kMark;
  std::string id{};
  friend bool operator==(const RecordRef&, const RecordRef&) = default;
};

/// What a result was calculated from; shared by the results of one analysis.
using ResultPart = std::variant<ResultPattern, RecordRef>;
using ResultParts = std::shared_ptr<const std::vector<ResultPart>>;
[[nodiscard]] ResultParts partsOf(std::vector<ResultPart> parts);

/// No value. `reason`: a clause without full stop; may be empty.
struct Undefined {
  Text reason{};
};

using ResultValue = std::variant<Undefined, double, std::int64_t, bool, Text, Interval>;

/// Whether a result belongs to the analysis that was planned with the cohort.
enum class Origin : std::uint8_t { kUnplanned, kPlanned };

/// A number, interval, word or hash of a cohort with its full description.
struct Result {
  ResultKey key;
  ResultValue value;
  std::int64_t n = 0;  ///< values used
  std::string flags;   ///< joined by "; "
  ResultParts madeOf;  ///< never empty
  Origin origin = Origin::kUnplanned;
};

/// Returns a value as a number; empty if it is not one.
[[nodiscard]] std::optional<double> numberIn(const ResultValue& value) noexcept;

/// Names of groups and occasions in keys, unique, in the order of CohortInputs.
struct ResultNames {
  std::vector<std::string> groups{};
  std::vector<std::string> occasions{};
};

/// Returns the cells of a key in cohort.csv: section, item, group, model, index, occasion, statistic.
[[nodiscard]] std::array<std::string, 7> keyCells(const ResultKey& key);
/// Returns these cells as one CSV line.
[[nodiscard]] std::string keyAddress(const ResultKey& key);

/// All results of a cohort, unique, in the order of adding.
class Ledger {
 public:
  Ledger() = default;
  explicit Ledger(ResultNames names) : names_(std::move(names)) {}

  /// Adds a result. Throws ContractError for a duplicate key, or a result calculated from nothing.
  void add(Result result);
  /// Returns the result of a key; null if there is none.
  [[nodiscard]] const Result* find(const ResultKey& key) const;
  /// Returns the matching results in order.
  [[nodiscard]] std::vector<const Result*> select(const ResultPattern& pattern) const;
  [[nodiscard]] const std::deque<Result>& every() const noexcept { return results_; }
  [[nodiscard]] const ResultNames& names() const noexcept { return names_; }
  /// Returns the name of a group of CohortInputs, for a key.
  [[nodiscard]] const std::string& group(std::size_t index) const { return names_.groups.at(index); }
  /// Returns the name of an occasion of CohortInputs, for a key; empty if there is none.
  [[nodiscard]] std::string occasion(std::size_t index) const;
  [[nodiscard]] std::string lastOccasion() const { return occasion(names_.occasions.size() - 1); }
  /// Visits the results as lines of cohort.csv: an interval "mean_95" as mean_lower_95 and mean_upper_95.
  void eachLine(const std::function<void(const Result&)>& visit) const;

  /// Returns a ledger of the results for which `shown` is true; it knows the keys of the others.
  [[nodiscard]] Ledger filtered(const std::function<bool(const Result&)>& shown) const;
  [[nodiscard]] bool hides(const ResultKey& key) const { return hidden_.contains(key); }

 private:
  ResultNames names_;
  std::deque<Result> results_;
  std::unordered_map<ResultKey, std::size_t, ResultKeyHash> byKey_;
  std::unordered_set<ResultKey, ResultKeyHash> hidden_;
  std::unordered_map<std::string, std::vector<std::size_t>> byPerson_;  // by ResultKey::of
};

}  // namespace torsio
