// SPDX-License-Identifier: GPL-3.0-or-later
// Results about runs and learning curves.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "assessment/results/report_sections.h"
#include "assessment/results/result_writer.h"
#include "assessment/statistics/curve_fit.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/quantiles.h"
#include "assessment/statistics/resampling.h"
#include "sim/core/foreign_recording.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

using enum ResultSection;

/// Adds the learning of a trainee: two halves of the twists, and a curve fitted to all of them.
void addCourse(const PracticeCourse& course, ResultWriter& rows) {
  rows.place.of = course.trainee;
  rows.place.group = rows.group(course.group);
  rows.madeOf =
      partsOf({ResultPattern{.section = kTrial, .statistic = "twist_error_deg", .of = course.trainee}});
  std::vector<double> number;
  std::vector<double> error;
  std::int64_t onTarget = 0;
  for (const JudgedTwist& attempt : course.attempts) {
    number.push_back(static_cast<double>(number.size() + 1));
    error.push_back(attempt.error_deg);
    onTarget += attempt.onTarget ? 1 : 0;
  }
  const std::span<const double> values(error);
  const std::size_t half = error.size() / 2;
  const std::int64_t n = std::ssize(error);
  rows.addCount("twists", n, n);
  rows.addCount("twists_on_target", onTarget, n);
  rows.add("mean_error_first_half_deg", half > 0 ? std::optional(meanOf(values.first(half))) : std::nullopt,
           static_cast<std::int64_t>(half));
  rows.add("mean_error_second_half_deg", meanOf(values.subspan(half)), n - static_cast<std::int64_t>(half));
  const Outcome<LearningCurve> fit = fitLearningCurve(LearningFamily::kExponential, number, error);
  if (!fit) {
    rows.put("error_left_deg", Undefined{fit.reason()}, n);
  } else {
    rows.setFlags(fit->asymptoteAtZero ? std::vector<std::string>{"held at zero"}
                                       : std::vector<std::string>{});
    rows.add("error_left_deg", fit->asymptoteAtZero ? 0.0 : fit->asymptote, n);
    rows.setFlags({});
  }
}

/// Adds to how many trainees a learning curve was fitted.
void addCurvesFitted(ResultWriter& rows, const Ledger& ledger) {
  const ResultPattern each{.section = kPractice, .statistic = "error_left_deg", .of = kEach};
  const std::vector<const Result*> all = ledger.select(each);
  if (all.empty()) {
    return;
  }
  rows.place = {.section = kPractice};
  rows.madeOf = partsOf({each});
  rows.addCount("trainees_with_curve",
                std::count_if(all.begin(), all.end(),
                              [](const Result* one) { return numberIn(one->value).has_value(); }),
                std::ssize(all));
}

/// Adds a group's mean error at its n-th twist, of at least two trainees who made it; returns of how many
/// twists in all.
std::int64_t addGroupCourse(const std::vector<PracticeCourse>& all, std::size_t group, ResultWriter& rows) {
  rows.place.of.clear();
  rows.place.group = rows.group(group);
  rows.madeOf = partsOf({runsOf("twist_error_deg", rows.place.group)});
  std::int64_t used = 0;
  for (std::size_t n = 0;; ++n) {
    std::vector<double> errors;
    for (const PracticeCourse& course : all) {
      if (course.group == group && n < course.attempts.size()) {
        errors.push_back(course.attempts[n].error_deg);
      }
    }
    if (errors.size() < 2) {
      break;
    }
    std::optional<Interval> interval = meanInterval(errors);
    if (interval) {
      interval->lower = std::max(0.0, interval->lower);
    }
    rows.place.number = static_cast<std::int64_t>(n) + 1;
    rows.addInterval("mean_twist_error_deg", meanOf(errors), interval, std::ssize(errors));
    used += std::ssize(errors);
  }
  rows.place.number = 0;
  return used;
}

/// Adds per group how a trainee's error in the second half of the twists goes with the score at the end.
/// Within the groups: what training does to both would pass for a relation.
void addErrorAndScore(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kPractice}, commonFlags(in));
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const ResultPattern halves{.section = kPractice,
                               .statistic = "mean_error_second_half_deg",
                               .of = kEach,
                               .group = ledger.group(g)};
    const ResultPattern atEnd{
        .statistic = "score", .of = kEach, .group = ledger.group(g), .occasion = ledger.lastOccasion()};
    std::vector<double> errors;
    std::vector<double> scores;
    for (const Result* half : ledger.select(halves)) {
      ResultKey key = atEnd;
      key.of = half->key.of;
      const Result* score = ledger.find(key);
      const std::optional<double> error = numberIn(half->value);
      const std::optional<double> points = score == nullptr ? std::nullopt : numberIn(score->value);
      if (error && points) {
        errors.push_back(*error);
        scores.push_back(*points);
      }
    }
    if (errors.empty()) {
      continue;
    }
    rows.place.group = ledger.group(g);
    rows.madeOf = partsOf({halves, atEnd});
    const Outcome<Correlation> found = pearson(errors, scores);
    if (found) {
      rows.addInterval("error_score_correlation", found->r, found->fisherInterval, std::ssize(errors));
    } else {
      rows.put("error_score_correlation", Undefined{found.reason()}, std::ssize(errors));
    }
  }
}

/// Adds the runs with twists by group and phase.
void addRunsByPhase(const CohortInputs& in, Ledger& ledger) {
  for (const PhaseRuns& phase : runsByPhase(in, ledger, RunKind::kTwists)) {
    const ResultKey& place = phase.place;
    const std::vector<const TrialSummaryRow*>& runs = phase.runs;
    ResultWriter rows(ledger, place, commonFlags(in));
    const std::int64_t n = std::ssize(runs);
    const auto madeOf = [&](const std::string& statistic) {
      rows.madeOf = partsOf({runsOf(statistic, place.group, place.when)});
    };
    const auto addMean = [&](const std::string& name, const std::string& of,
                             std::optional<double> TrialSummaryRow::*member) {
      std::vector<double> values;
      for (const TrialSummaryRow* run : runs) {
        if (const std::optional<double>& value = run->*member) {
          values.push_back(*value);
        }
      }
      madeOf(of);
      rows.add(name, values.empty() ? std::nullopt : std::optional(meanOf(values)), std::ssize(values));
    };
    double minutes = 0.0;
    std::int64_t twists = 0;
    std::int64_t onTarget = 0;
    for (const TrialSummaryRow* run : runs) {
      minutes += run->minutes;
      twists += run->twists;
      onTarget += run->twistsOnTarget;
    }
    madeOf("minutes");
    rows.addCount("runs", n, n);
    rows.add("minutes", minutes, n);
    madeOf("twists");
    rows.addCount("twists", twists, n);
    madeOf("twists_on_target");
    rows.addCount("twists_on_target", onTarget, n);
    addMean("mean_absolute_error_deg", "mean_absolute_error_deg", &TrialSummaryRow::meanAbsoluteError_deg);
    addMean("mean_peak_torque_Nm", "peak_torque_Nm", &TrialSummaryRow::peakTorque_Nm);
    addMean("mean_peak_force_N", "peak_force_N", &TrialSummaryRow::peakForce_N);
  }
}

/// Adds to each run's own measurements how many re-grips it needed beyond the least number.
std::map<std::string, double> untwistingValues(const TrialSummaryRow& trial) {
  std::map<std::string, double> values = trial.detorsion;
  const auto regrips = values.find("detorse.regrips");
  const auto least = values.find("detorse.least_regrips");
  if (regrips != values.end() && least != values.end()) {
    values[kRegripsBeyondLeast] = regrips->second - least->second;
  }
  return values;
}

/// Adds how long the instrument was out of view in the runs of a group and phase, and the share of their
/// time.
void addTimeOutOfView(const ResultKey& place, const std::map<std::string, std::vector<double>>& values,
                      ResultWriter& rows) {
  const auto lost = values.find(idOf(Quantity::kUnseen));
  const auto time = values.find(idOf(Quantity::kTime));
  if (lost == values.end() || time == values.end()) {
    return;
  }
  const auto sum = [](const std::vector<double>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0);
  };
  const std::int64_t n = std::ssize(lost->second);
  const double whole_s = sum(time->second);
  rows.madeOf = partsOf({runsOf(lost->first, place.group, place.when)});
  rows.add(kTimeOutOfView, sum(lost->second), n);
  rows.madeOf =
      partsOf({runsOf(lost->first, place.group, place.when), runsOf(time->first, place.group, place.when)});
  rows.add(kShareOutOfView, whole_s > 0.0 ? std::optional(sum(lost->second) / whole_s) : std::nullopt, n);
}

/// Adds untwistings and recordings of other equipment by group and phase: in how many runs a quantity is
/// above zero, of those that have it, and its median.
void addMediansByPhase(const CohortInputs& in, RunKind kind, Ledger& ledger) {
  for (const auto& [group, place, runs] : runsByPhase(in, ledger, kind)) {
    ResultWriter rows(ledger, place, commonFlags(in));
    std::map<std::string, std::vector<double>> values;
    for (const TrialSummaryRow* run : runs) {
      for (const auto& [id, value] : untwistingValues(*run)) {
        values[id].push_back(value);
      }
    }
    rows.madeOf = partsOf({runsOf("minutes", place.group, place.when)});
    rows.addCount("measured_runs", std::ssize(runs), std::ssize(runs));
    for (const auto& [id, found] : values) {
      const std::int64_t n = std::ssize(found);
      rows.madeOf = id == kRegripsBeyondLeast
                        ? partsOf({runsOf("detorse.regrips", place.group, place.when),
                                   runsOf("detorse.least_regrips", place.group, place.when)})
                        : partsOf({runsOf(id, place.group, place.when)});
      rows.addCount("above_zero_" + id,
                    std::count_if(found.begin(), found.end(), [](double value) { return value > 0.0; }), n);
      rows.add("median_" + id, quantile(found, 0.5), n);
    }
    addTimeOutOfView(place, values, rows);
  }
}

/// Adds how many runs of each kind there are.
void addRunCounts(const CohortInputs& in, Ledger& ledger) {
  for (const RunKind kind : {RunKind::kTwists, RunKind::kUntwisting, RunKind::kForeign}) {
    std::int64_t runs = 0;
    for (const PhaseRuns& phase : runsByPhase(in, ledger, kind)) {
      runs += std::ssize(phase.runs);
    }
    if (runs > 0) {
      ResultWriter rows(ledger, runsKey(kind), commonFlags(in));
      rows.madeOf = partsOf(
          {ResultPattern{.section = kTrial, .statistic = "minutes", .of = kEach, .model = rows.place.model}});
      rows.addCount(kind == RunKind::kTwists ? "runs" : "measured_runs", runs, runs);
    }
  }
}

/// Adds each trainee's course over the recordings of other equipment.
void addForeignCourses(const CohortInputs& in, Ledger& ledger) {
  std::map<ResultKey, std::vector<double>> courses;
  for (const TrialSummaryRow& trial : in.trials) {
    for (const Quantity quantity : kForeignQuantities) {
      const std::string metric = idOf(quantity);
      const auto found = trial.detorsion.find(metric);
      if (trial.model == kForeignModel && found != trial.detorsion.end()) {
        courses[foreignKey(ledger, trial.trainee, trial.group, metric)].push_back(found->second);
      }
    }
  }
  for (const auto& [place, course] : courses) {
    ResultWriter rows(ledger, place, commonFlags(in));
    rows.madeOf = partsOf({ResultPattern{
        .section = kTrial, .statistic = place.index, .of = place.of, .model = std::string(kForeignModel)}});
    std::vector<double> number(course.size());
    std::iota(number.begin(), number.end(), 1.0);
    const std::int64_t n = std::ssize(course);
    rows.addCount("runs", n, n);
    rows.add("first", course.front(), 1);
    rows.add("last", course.back(), 1);
    rows.add("left_in_the_end", fitLearningCurve(LearningFamily::kExponential, number, course),
             &LearningCurve::asymptote, n);
  }
}

}  // namespace

ResultKey foreignKey(const Ledger& ledger, const std::string& trainee, std::size_t group,
                     const std::string& metric) {
  return {.section = kPractice,
          .of = trainee,
          .group = ledger.group(group),
          .model = std::string(kForeignModel),
          .index = metric};
}

std::vector<PracticeCourse> practiceCourses(const CohortInputs& in) {
  std::map<std::pair<std::size_t, std::string>, PracticeCourse> found;
  for (const TrialSummaryRow& trial : in.trials) {
    if (!trial.attempts.empty()) {
      PracticeCourse& course = found[{trial.group, trial.trainee}];
      course.trainee = trial.trainee;
      course.group = trial.group;
      course.attempts.insert(course.attempts.end(), trial.attempts.begin(), trial.attempts.end());
    }
  }
  std::vector<PracticeCourse> out;
  for (auto& [place, course] : found) {
    out.push_back(std::move(course));
  }
  return out;
}

ResultKey runsKey(RunKind kind) {
  return {.section = kTrial, .model = kind == RunKind::kForeign ? std::string(kForeignModel) : std::string()};
}

std::vector<PhaseRuns> runsByPhase(const CohortInputs& in, const Ledger& ledger, RunKind kind) {
  std::map<std::pair<std::size_t, std::string>, PhaseRuns> phases;
  for (const TrialSummaryRow& trial : in.trials) {
    const bool foreign = trial.model == kForeignModel;
    const RunKind own = trial.detorsion.empty() ? RunKind::kTwists
                        : foreign               ? RunKind::kForeign
                                                : RunKind::kUntwisting;
    if (own == kind) {
      PhaseRuns& phase = phases[{trial.group, trial.phase.str()}];
      phase.group = trial.group;
      phase.place = {.section = kTrial,
                     .group = ledger.group(trial.group),
                     .model = foreign ? trial.model : std::string(),
                     .when = trial.phase.str()};
      phase.runs.push_back(&trial);
    }
  }
  std::vector<PhaseRuns> out;
  for (auto& [place, phase] : phases) {
    out.push_back(std::move(phase));
  }
  return out;
}

void addPracticeResults(const CohortInputs& in, Ledger& ledger) {
  const std::vector<PracticeCourse> courses = practiceCourses(in);
  ResultWriter rows(ledger, {.section = kPractice}, commonFlags(in));
  for (const PracticeCourse& course : courses) {
    addCourse(course, rows);
  }
  addCurvesFitted(rows, ledger);
  std::int64_t inMeans = 0;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    inMeans += addGroupCourse(courses, g, rows);
  }
  if (!courses.empty()) {
    rows.place = {.section = kPractice};
    rows.madeOf = partsOf({ResultPattern{.section = kTrial, .statistic = "twist_error_deg", .of = kEach}});
    const std::int64_t twists = std::accumulate(
        courses.begin(), courses.end(), std::int64_t{0},
        [](std::int64_t sum, const PracticeCourse& one) { return sum + std::ssize(one.attempts); });
    rows.addCount("twists", twists, twists);
    rows.addCount("twists_in_means", inMeans, twists);
  }
  addErrorAndScore(in, ledger);
  addRunsByPhase(in, ledger);
  addMediansByPhase(in, RunKind::kUntwisting, ledger);
  addMediansByPhase(in, RunKind::kForeign, ledger);
  addRunCounts(in, ledger);
  addForeignCourses(in, ledger);
}

}  // namespace torsio
