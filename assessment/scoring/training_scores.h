// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"

namespace torsio {

inline constexpr const char* kTrainingFormulaVersion = "training-1";

/// How a mark was given.
enum class MarkWay : std::uint8_t {
  kEntered,  ///< without any sheet
  kBlinded,  ///< on a recording under a case label, by a sheet of the desk
  kLive,     ///< by a sheet at the real arm
};

/// One mark of the training study: a chief physician's score of one trainee at one occasion.
struct TrainingMark {
  std::string trainee;
  std::size_t group = 0;     ///< 0 .. groups - 1
  std::size_t occasion = 0;  ///< 0 before, 1 after 20 min, 2 after 40 min
  std::string rater;
  std::int64_t steps = 0;
  MarkId id{};  ///< empty: it is not in the record
  std::int64_t version = 1;
  std::int64_t submittedUtc_us = 0;  ///< 0: not known
  std::string raterClass{};          ///< of the rater, as a code; empty: not known
  MarkWay way = MarkWay::kEntered;
};

/// A trainee's score at one occasion: the mean over the raters (paper section 6).
struct TraineeScore {
  std::string trainee;
  std::size_t group = 0;
  std::size_t number = 0;  ///< 1 .. size of the group, in the order of the trainee codes
  std::size_t occasion = 0;
  std::int64_t sum_steps = 0;
  std::int64_t n = 0;  ///< raters
  double score = 0.0;  ///< points
};

/// One group at one occasion, with three readings of the variance in Fig. 23 and their divisors.
struct GroupSummary {
  std::size_t group = 0;
  std::size_t occasion = 0;
  std::int64_t trainees = 0;
  std::int64_t marks = 0;
  double mean = 0.0;                               ///< of the trainee scores
  double varianceOfScores = 0.0;                   ///< (a) of the trainee scores, divisor n
  std::optional<double> sampleVarianceOfScores;    ///< (a) divisor n - 1
  double varianceOfMarks = 0.0;                    ///< (b) of all marks of the group, divisor n
  std::optional<double> meanBetweenRaterVariance;  ///< (c) mean over trainees, divisor n - 1 in each
  double min = 0.0;
  double max = 0.0;
  double median = 0.0;
};

/// Computes the score of every trainee at every occasion with marks, ordered by occasion, group, number.
/// Throws Error{kBadData} if a mark is off the scale or duplicate, or a trainee appears in two groups.
[[nodiscard]] std::vector<TraineeScore> traineeScores(const ScoreScale& scale,
                                                      std::span<const TrainingMark> marks);

/// Summarises every group at every occasion with marks, ordered by occasion, then group. Sums of steps are
/// exact; every value is rounded once unless the rater counts have no practical common denominator.
[[nodiscard]] std::vector<GroupSummary> groupSummaries(const ScoreScale& scale,
                                                       std::span<const TrainingMark> marks);

/// Returns the gains (occasion `to` minus `from`) of the group's trainees with both scores, by code, as
/// integers on a common scale of all groups. They order exactly like the true differences; differences of
/// doubles would break ties. Empty if the numbers of raters have no common multiple within a million.
[[nodiscard]] std::optional<std::vector<std::int64_t>> exactGains(std::span<const TraineeScore> scores,
                                                                  std::size_t from, std::size_t to,
                                                                  std::size_t group);

}  // namespace torsio
