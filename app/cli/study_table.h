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

/// Somebody with scores at one or more occasions.
struct Subject {
  std::string name;
  std::size_t group = 0;
  std::size_t row = 0;  ///< of the table, where the subject first stands
  /// By occasion; with a column for raters the mean of the marks that were given.
  std::map<std::string, double> scores{};
  std::map<std::string, std::vector<std::optional<double>>> marks{};  ///< by occasion, then rater
};

/// Groups, occasions, raters and subjects in the order in which the file names them.
struct Study {
  std::vector<std::string> groups;
  std::vector<std::string> occasions;
  std::vector<std::string> raters;  ///< empty: the file has no column for them
  std::vector<Subject> subjects;
};

/// Reads the columns subject and score, and group, occasion and rater where there are any; without them all
/// subjects are one group "all", all scores of the occasion "only". Throws Error{kBadData} for a second score
/// of a subject at one occasion (by one rater) and for a subject in two groups.
[[nodiscard]] Study readStudy(const CsvTable& table);

/// Gathers the scores at one occasion, group by group.
[[nodiscard]] Groups scoresAt(const Study& study, const std::string& occasion);

/// The subjects of one group with a score at every occasion asked for.
struct CompleteSubjects {
  std::vector<std::vector<double>> scores;  ///< subjects x occasions
  std::vector<std::string> names;           ///< of these subjects
  std::vector<std::string> leftOut;         ///< subjects of the group without some of these scores
};
/// Gathers the subjects of `group` that have a score at all of `occasions`.
[[nodiscard]] CompleteSubjects completeSubjects(const Study& study, std::size_t group,
                                                const std::vector<std::string>& occasions);

/// Gathers the marks of every subject at two occasions; there are raters.
[[nodiscard]] std::vector<MarkedTrainee> markedSubjects(const Study& study, const std::string& before,
                                                        const std::string& after);

}  // namespace torsio::cli
