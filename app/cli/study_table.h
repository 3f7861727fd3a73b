// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/services/base/csv_table.h"
#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/missing_marks.h"

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

/// Returns the scores at one occasion, by group.
[[nodiscard]] Groups scoresAt(const Study& study, const std::string& occasion);

/// Subjects of one group with a score at every requested occasion.
struct CompleteSubjects {
  std::vector<std::vector<double>> scores;  ///< subjects x occasions
  std::vector<std::string> names;           ///< of these subjects
  std::vector<std::string> leftOut;         ///< subjects of the group that lack some of these scores
};
/// Returns the subjects of `group` with scores at all `occasions`.
[[nodiscard]] CompleteSubjects completeSubjects(const Study& study, std::size_t group,
                                                const std::vector<std::string>& occasions);

/// Returns the marks of every subject at two occasions; requires a rater column.
[[nodiscard]] std::vector<MarkedTrainee> markedSubjects(const Study& study, const std::string& before,
                                                        const std::string& after);

}  // namespace torsio::cli
