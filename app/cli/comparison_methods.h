// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/services/base/csv_table.h"
#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/missing_marks.h"
#include "assessment/statistics/rank_tests.h"

namespace torsio::cli {

/// A subject with scores at one or more occasions.
struct Subject {
  std::string name;
  std::size_t group = 0;
  std::size_t row = 0;  ///< first row of the subject in the table
  /// By occasion; with a rater column, the mean of the marks given.
  std::map<std::string, double> scores{};
  std::map<std::string, std::vector<std::optional<double>>> marks{};  ///< by occasion, then rater
};

/// Groups, occasions, raters and subjects in file order.
struct Study {
  std::vector<std::string> groups;
  std::vector<std::string> occasions;
  std::vector<std::string> raters;  ///< empty: no rater column
  std::vector<Subject> subjects;
};

/// Reads the columns subject and score and, if present, group, occasion and rater. Without them all subjects
/// form the group "all", all scores the occasion "only". Throws Error{kBadData} for a duplicate score of a
/// subject at an occasion (by a rater) and for a subject in two groups.
[[nodiscard]] Study readStudy(const CsvTable& table);

[[nodiscard]] Groups scoresAt(const Study& study, const std::string& occasion);

/// Subjects of one group with a score at every requested occasion.
struct CompleteSubjects {
  std::vector<std::vector<double>> scores;  ///< subjects x occasions
  std::vector<std::string> names;           ///< of these subjects
  std::vector<std::string> leftOut;         ///< subjects of the group that lack some of these scores
};
[[nodiscard]] CompleteSubjects completeSubjects(const Study& study, std::size_t group,
                                                const std::vector<std::string>& occasions);

/// Returns the marks of every subject at two occasions; requires a rater column.
[[nodiscard]] std::vector<MarkedTrainee> markedSubjects(const Study& study, const std::string& before,
                                                        const std::string& after);

// Output of `torsio compare-groups`; docs/cli.md lists the keys. Private to app/cli.

/// Adjustment of p values for several pairs of groups.
enum class Adjustment { kHolm, kHochberg, kBonferroni, kBenjaminiHochberg };

/// Options of tests between groups at one occasion.
struct GroupRequest {
  Adjustment adjustment = Adjustment::kHolm;
  std::optional<double> margin;  ///< equivalence margin in the unit of the scores; empty: not tested
  std::uint64_t seed = 1;        ///< for permutations that are too many to count
};
/// Adds every test between the groups at one occasion to `out`. With more than two groups each pair has p by
/// Holm, and by `adjustment` if different; intervals are not adjusted unless their name says so.
void addGroupTests(nlohmann::ordered_json& out, const std::vector<std::string>& names, const Groups& groups,
                   const GroupRequest& request);
[[nodiscard]] nlohmann::ordered_json equivalenceJson(double difference, double error, double df,
                                                     double margin);
/// Options of comparisons of subjects with scores at two occasions.
struct CovarianceRequest {
  std::string covariate;
  std::string outcome;            ///< another occasion
  std::optional<double> margin;   ///< equivalence margin, points; empty: not tested
  std::optional<Interval> scale;  ///< lowest and highest mark, for bounds; empty: no bounds
  bool residuals = false;         ///< include residuals of each subject, for plots
};
/// Returns the analysis of covariance of the outcome on the covariate.
[[nodiscard]] nlohmann::ordered_json ancovaJson(const Study& study, const CovarianceRequest& request);
/// Returns the mixed model of single marks, the missing marks, and their bounds.
[[nodiscard]] nlohmann::ordered_json mixedModelJson(const Study& study, const CovarianceRequest& request);
/// Returns the analysis of variance of groups by occasions.
[[nodiscard]] nlohmann::ordered_json mixedAnovaJson(const Study& study);

/// Tests of the same subjects at several occasions.
enum class PairedTest { kT, kSignedRank, kPermutation, kFriedman };

/// Returns limits so that `tests` tests of `size` numbers take some tenths of a second in total: how many
/// permutations are counted exactly, and how many are drawn otherwise.
[[nodiscard]] MonteCarlo permutationsWithin(std::uint64_t seed, double size, double tests);
/// Adds whether every permutation was counted and, for random ones, the error of p.
void addMonteCarlo(bool exact, double error, const MonteCarlo& choice, nlohmann::ordered_json& out);

/// Returns, for every group, the test of the last occasion against the first (Friedman: of all occasions) and
/// their correlation.
[[nodiscard]] nlohmann::ordered_json pairedJson(const Study& study, PairedTest test, std::uint64_t seed);

/// Statistic to resample, and how.
struct BootstrapRequest {
  bool median = false;         ///< otherwise the mean
  bool everyResample = false;  ///< all n^n resamples instead of random ones
  std::uint64_t seed = 1;
  std::int64_t resamples = 9999;
};

/// Returns bootstrap intervals for every list of values, labelled by group.
[[nodiscard]] nlohmann::ordered_json bootstrapJson(const std::vector<std::string>& names,
                                                   const Groups& values, const BootstrapRequest& request);
/// Returns the gains of each group: last occasion minus first, for subjects with both.
[[nodiscard]] Groups gainsOf(const Study& study);

}  // namespace torsio::cli
