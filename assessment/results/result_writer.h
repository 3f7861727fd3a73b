// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/results/ledger.h"
#include "assessment/results/study_analysis.h"
#include "assessment/statistics/values.h"

// Analyses that fill the ledger. Private to assessment/results.
namespace torsio {

using ResultFlags = std::vector<std::string>;

[[nodiscard]] inline ResultFlags flagIf(bool set, const char* flag) {
  return set ? ResultFlags{flag} : ResultFlags{};
}

/// Matches the raters' marks of an occasion and group, by their names; empty: of all.
[[nodiscard]] inline ResultPattern marksAt(const std::string& occasion, const std::string& group = {}) {
  return {.statistic = "rater_mark", .of = kEach, .group = group, .occasion = occasion};
}

/// Matches the results of single runs of a group, by its name.
[[nodiscard]] inline ResultPattern runsOf(const std::string& statistic, const std::string& group,
                                          const std::string& phase = {}) {
  return {
      .section = ResultSection::kTrial, .statistic = statistic, .of = kEach, .group = group, .when = phase};
}

/// Adds results with a common key and sources that differ in statistic and value.
class ResultWriter {
 public:
  /// `flags`: of the cohort; `own`: of these results.
  ResultWriter(Ledger& ledger, ResultKey at, std::vector<Text> flags, const ResultFlags& own = {})
      : place(std::move(at)), ledger_(ledger), flags_(std::move(flags)) {
    setFlags(own);
  }

  ResultKey place;
  ResultParts madeOf;
  Origin origin = Origin::kUnplanned;

  /// Return the names of a group and of an occasion of CohortInputs, for `place`.
  [[nodiscard]] std::string group(std::size_t index) const { return ledger_.group(index); }
  [[nodiscard]] std::string occasion(std::size_t index) const { return ledger_.occasion(index); }

  /// Sets flags of these results in addition to the cohort's.
  void setFlags(const ResultFlags& own);

  /// Adds a number; empty if undefined.
  void add(const std::string& statistic, const std::optional<double>& value, std::int64_t n);
  /// Adds a member of an outcome, undefined for the outcome's reason.
  template <typename T, typename Member>
  void add(const std::string& statistic, const Outcome<T>& outcome, Member T::*member, std::int64_t n) {
    outcome ? add(statistic, (*outcome).*member, n) : put(statistic, Undefined{outcome.reason()}, n);
  }
  void addCount(const std::string& statistic, std::int64_t count, std::int64_t n) {
    put(statistic, count, n);
  }
  /// Adds a hash, a word, or yes or no.
  void put(const std::string& statistic, ResultValue value, std::int64_t n);
  /// Adds a number, and its interval as `statistic`_95.
  void addInterval(const std::string& statistic, double value, const std::optional<Interval>& interval,
                   std::int64_t n);

 private:
  Ledger& ledger_;
  std::vector<Text> flags_;
  std::string joined_;
};

/// Adds the evaluation of models: indices, scores and differences, or what is there before a class of raters
/// has scored everything.
void addEvaluationResults(const CohortInputs& inputs, Ledger& ledger);

/// Adds the criteria: every scoring sheet used with its anchors, marks per criterion of each group and
/// trainee, and all single ones (criteria_section.cpp).
void addCriteriaResults(const CohortInputs& inputs, Ledger& ledger);

/// Adds who takes part, and their times; `all`: including marks that are not shown.
void addParticipantsResults(const CohortInputs& inputs, const CohortInputs& all, Ledger& ledger);
/// Adds the runs and what was learned in them.
void addPracticeResults(const CohortInputs& inputs, Ledger& ledger);

/// Adds what the record as a whole holds: sources, ways in which marks were given, sums over the recordings.
void addRecordResults(const CohortInputs& inputs, Ledger& ledger);

/// Add results about raters and groups from the marks of the training study.
void addAgreementResults(const CohortInputs& inputs, const StudyAnalysis& study, Ledger& ledger);
void addComparisonResults(const CohortInputs& inputs, const StudyAnalysis& study, Ledger& ledger);
/// Adds the comparison within the centres of a pooled record, and who took part at each.
void addSiteResults(const CohortInputs& inputs, const StudyAnalysis& study, Ledger& ledger);

}  // namespace torsio
