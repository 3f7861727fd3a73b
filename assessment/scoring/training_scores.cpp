// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring/training_scores.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <tuple>

#include <boost/multiprecision/cpp_int.hpp>

#include "assessment/scoring/exact_quotient.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

using WideInteger = boost::multiprecision::int256_t;  // sums of squares can pass 2^63, never 2^200

constexpr std::int64_t kMaxCommonRaters = 1'000'000;

using Cell = std::tuple<std::size_t, std::size_t, std::string>;  // occasion, group, trainee
using Cells = std::map<Cell, std::vector<std::int64_t>>;

[[noreturn]] void refuseMark(const TrainingMark& mark, const Text& what, const Text& remedy) {
  throw Error(
      ErrorCode::kBadData, what,
      "trainee " + mark.trainee + ", occasion " + std::to_string(mark.occasion) + ", rater " + mark.rater,
      remedy);
}

Cells collect(const ScoreScale& scale, std::span<const TrainingMark> marks) {
  validateScale(scale);
  Cells cells;
  std::map<std::string, std::size_t> groupOf;
  std::map<const std::vector<std::int64_t>*, std::set<std::string_view>> ratersOf;
  auto cell = cells.end();  // marks of one trainee are mostly adjacent
  std::set<std::string_view>* raters = nullptr;
  for (const TrainingMark& mark : marks) {
    if (!isOnScale(mark.steps, scale)) {
      refuseMark(
          mark,
          Text::verbatim("score %1 is outside the scale", std::to_string(pointsFromSteps(mark.steps, scale))),
          Text::verbatim("Correct the mark; marks are never clamped."));
    }
    if (cell == cells.end() || std::get<2>(cell->first) != mark.trainee ||
        std::get<0>(cell->first) != mark.occasion || std::get<1>(cell->first) != mark.group) {
      const auto [known, isNew] = groupOf.emplace(mark.trainee, mark.group);
      if (!isNew && known->second != mark.group) {
        refuseMark(mark, Text::verbatim("a trainee appears in two groups"),
                   Text::verbatim("Analyse as allocated."));
      }
      cell = cells.try_emplace({mark.occasion, mark.group, mark.trainee}).first;
      raters = &ratersOf[&cell->second];
    }
    if (!raters->insert(mark.rater).second) {
      refuseMark(mark, Text::verbatim("the same mark appears twice"),
                 Text::verbatim("Keep one; a correction supersedes the earlier mark."));
    }
    cell->second.push_back(mark.steps);
  }
  return cells;
}

std::int64_t sumOf(const std::vector<std::int64_t>& values) {
  return std::accumulate(values.begin(), values.end(), std::int64_t{0});
}

/// Returns n times the sum of squares about the mean: an integer.
WideInteger spreadOf(const std::vector<std::int64_t>& values) {
  WideInteger squares = 0;
  for (const std::int64_t x : values) {
    squares += WideInteger(x) * x;
  }
  const WideInteger sum = sumOf(values);
  return std::ssize(values) * squares - sum * sum;
}

double quotientOf(const WideInteger& spread, std::initializer_list<std::int64_t> divisors) {
  WideInteger denominator = 1;
  for (const std::int64_t divisor : divisors) {
    denominator *= divisor;
  }
  return nearestQuotient<WideInteger>(spread, denominator);
}

/// Trainee scores of a group as integers in units of 1 / denominator points.
struct CommonScores {
  std::vector<std::int64_t> values;
  std::int64_t denominator = 1;
};

CommonScores commonScores(const std::vector<const std::vector<std::int64_t>*>& trainees, std::int64_t q) {
  std::int64_t lcm = 1;
  for (const auto* marks : trainees) {
    if (lcm <= kMaxCommonRaters) {
      lcm = std::lcm(lcm, std::ssize(*marks));
    }
  }
  // Without a practical common denominator: units of a millionth of a step, far below any reporting
  // precision.
  const bool exact = lcm <= kMaxCommonRaters;
  const std::int64_t common = exact ? lcm : kMaxCommonRaters;
  CommonScores out;
  out.denominator = common * q;
  for (const auto* marks : trainees) {
    const std::int64_t n = std::ssize(*marks);
    const std::int64_t scaled = sumOf(*marks) * common;
    out.values.push_back(exact ? scaled / n : (2 * scaled + n) / (2 * n));
  }
  return out;
}

GroupSummary summarise(std::size_t occasion, std::size_t group,
                       const std::vector<const std::vector<std::int64_t>*>& trainees, std::int64_t q) {
  GroupSummary out;
  out.group = group;
  out.occasion = occasion;
  out.trainees = std::ssize(trainees);
  CommonScores scores = commonScores(trainees, q);
  const std::int64_t n = out.trainees;
  const std::int64_t d = scores.denominator;
  out.mean = roundedQuotient(sumOf(scores.values), n * d);
  const WideInteger spread = spreadOf(scores.values);
  out.varianceOfScores = quotientOf(spread, {n, n, d, d});
  if (n > 1) {
    out.sampleVarianceOfScores = quotientOf(spread, {n, n - 1, d, d});
  }
  std::vector<std::int64_t> all;
  double between = 0.0;
  WideInteger betweenNumerator = 0;
  bool betweenDefined = true;
  const std::int64_t k = std::ssize(*trainees.front());
  bool sameCount = true;
  for (const auto* marks : trainees) {
    all.insert(all.end(), marks->begin(), marks->end());
    const std::int64_t raters = std::ssize(*marks);
    betweenDefined = betweenDefined && raters > 1;
    sameCount = sameCount && raters == k;
    betweenNumerator += spreadOf(*marks);
    if (raters > 1) {
      between += quotientOf(spreadOf(*marks), {raters, raters - 1, q, q});
    }
  }
  out.marks = std::ssize(all);
  out.varianceOfMarks = quotientOf(spreadOf(all), {out.marks, out.marks, q, q});
  if (betweenDefined) {
    out.meanBetweenRaterVariance =
        sameCount ? quotientOf(betweenNumerator, {n, k, k - 1, q, q}) : between / static_cast<double>(n);
  }
  std::sort(scores.values.begin(), scores.values.end());
  out.min = roundedQuotient(scores.values.front(), d);
  out.max = roundedQuotient(scores.values.back(), d);
  const std::size_t half = scores.values.size() / 2;
  out.median = scores.values.size() % 2 == 1
                   ? roundedQuotient(scores.values[half], d)
                   : roundedQuotient(scores.values[half - 1] + scores.values[half], 2 * d);
  return out;
}

}  // namespace

std::vector<TraineeScore> traineeScores(const ScoreScale& scale, std::span<const TrainingMark> marks) {
  const Cells cells = collect(scale, marks);
  std::map<std::size_t, std::set<std::string>> members;
  for (const auto& [cell, steps] : cells) {
    members[std::get<1>(cell)].insert(std::get<2>(cell));
  }
  std::vector<TraineeScore> out;
  for (const auto& [cell, steps] : cells) {
    const auto& [occasion, group, trainee] = cell;
    const std::set<std::string>& of = members[group];
    TraineeScore score{.trainee = trainee, .group = group, .occasion = occasion};
    score.number = static_cast<std::size_t>(std::distance(of.begin(), of.find(trainee))) + 1;
    score.sum_steps = sumOf(steps);
    score.n = std::ssize(steps);
    score.score = roundedQuotient(score.sum_steps, score.n * scale.stepsPerPoint);
    out.push_back(std::move(score));
  }
  return out;
}

std::vector<GroupSummary> groupSummaries(const ScoreScale& scale, std::span<const TrainingMark> marks) {
  const Cells cells = collect(scale, marks);
  std::map<std::pair<std::size_t, std::size_t>, std::vector<const std::vector<std::int64_t>*>> groups;
  for (const auto& [cell, steps] : cells) {
    groups[{std::get<0>(cell), std::get<1>(cell)}].push_back(&steps);
  }
  std::vector<GroupSummary> out;
  out.reserve(groups.size());
  for (const auto& [key, trainees] : groups) {
    out.push_back(summarise(key.first, key.second, trainees, scale.stepsPerPoint));
  }
  return out;
}

std::optional<std::vector<std::int64_t>> exactGains(std::span<const TraineeScore> scores, std::size_t from,
                                                    std::size_t to, std::size_t group) {
  std::int64_t common = 1;
  for (const TraineeScore& score : scores) {
    common = std::lcm(common, score.n);
    if (common > kMaxCommonRaters) {
      return std::nullopt;
    }
  }
  std::map<std::string, std::int64_t> before;
  std::map<std::string, std::int64_t> after;
  for (const TraineeScore& score : scores) {
    if (score.group == group && (score.occasion == from || score.occasion == to)) {
      (score.occasion == from ? before : after)[score.trainee] = score.sum_steps * (common / score.n);
    }
  }
  std::vector<std::int64_t> gains;
  for (const auto& [trainee, sum] : before) {
    if (const auto at = after.find(trainee); at != after.end()) {
      gains.push_back(at->second - sum);
    }
  }
  return gains;
}

}  // namespace torsio
