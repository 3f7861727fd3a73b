// SPDX-License-Identifier: GPL-3.0-or-later
// Results about who takes part, their times, runs and learning curves.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "assessment/results/aggregated_inputs.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/received_training.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/result_writer.h"
#include "assessment/statistics/curve_fit.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/quantiles.h"
#include "sim/core/foreign_recording.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

using enum ResultSection;

/// Returns the results of single runs of a group, by its name.
ResultPattern runsOf(const std::string& statistic, const std::string& group, const std::string& phase = {}) {
  return {.section = kTrial, .statistic = statistic, .of = kEach, .group = group, .when = phase};
}

/// Adds who was allocated, withdrew, trained and was scored; `all`: including marks that are not shown.
void addParticipants(const CohortInputs& in, const CohortInputs& all, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kParticipants}, commonFlags(in));
  const ResultPart enrolments = RecordRef{RecordKind::kEnrolments};
  const std::int64_t everybody = std::ssize(in.trainees);
  rows.madeOf = partsOf({enrolments});
  rows.addCount("trainees", everybody, everybody);
  rows.addCount("groups", std::ssize(in.groups), everybody);
  rows.addCount("withdrew",
                std::count_if(in.trainees.begin(), in.trainees.end(),
                              [](const CohortTrainee& trainee) { return trainee.withdrew; }),
                everybody);
  rows.addCount("deviations", std::ssize(in.deviations), everybody);
  if (!in.deviations.empty()) {
    std::map<std::string, std::int64_t> kinds;
    for (const CohortDeviation& deviation : in.deviations) {
      ++kinds[deviation.kind];
    }
    rows.put("deviations_by_kind", countsText({kinds.begin(), kinds.end()}, in.identity), everybody);
  }
  if (!in.allocation.sealed && !in.allocation.method.empty()) {
    rows.put("seed", Text(std::to_string(in.allocation.seed)), everybody);
  }
  rows.addCount("not_allocated", in.notAllocated, everybody);
  rows.addCount("moved_by_hand", in.allocation.movedByHand, everybody);
  rows.addCount("allocated_before_commitment", in.allocation.allocatedBeforeLock, everybody);
  rows.addCount("enrolled_before_commitment", in.allocation.enrolledBeforeLock, everybody);
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    std::map<std::string, std::int64_t> sexes;
    std::map<std::string, std::int64_t> levels;
    std::int64_t allocated = 0;
    std::int64_t withdrew = 0;
    for (const CohortTrainee& trainee : in.trainees) {
      if (trainee.group == g) {
        ++allocated;
        withdrew += trainee.withdrew ? 1 : 0;
        ++sexes[trainee.sex];
        ++levels[trainee.level];
      }
    }
    rows.place.group = rows.group(g);
    rows.madeOf = partsOf({enrolments});
    rows.addCount("allocated", allocated, allocated);
    rows.addCount("withdrew", withdrew, allocated);
    if (allocated > 0) {
      rows.put("by_sex", countsText({sexes.begin(), sexes.end()}, in.identity), allocated);
      rows.put("by_level", countsText({levels.begin(), levels.end()}, in.identity), allocated);
    }
    rows.madeOf = partsOf({enrolments, runsOf("minutes", rows.place.group)});
    const auto runs = [&](bool interrupted) {
      return std::count_if(in.trials.begin(), in.trials.end(), [&](const TrialSummaryRow& trial) {
        return trial.group == g && (trial.interrupted || !interrupted);
      });
    };
    rows.addCount("runs", runs(false), allocated);
    rows.addCount("runs_interrupted", runs(true), allocated);
    rows.madeOf = partsOf({enrolments, RecordRef{RecordKind::kSheetRequests}});
    for (std::size_t t = 0; t < in.occasions.size(); ++t) {
      rows.place.occasion = rows.occasion(t);
      rows.addCount(
          "scored",
          std::count_if(all.scores.begin(), all.scores.end(),
                        [&](const TraineeScore& score) { return score.group == g && score.occasion == t; }),
          allocated);
    }
    rows.place.occasion.clear();
    rows.madeOf = partsOf({RecordRef{RecordKind::kCohortPlan}});
    for (const auto& [name, planned] : {std::pair("planned_virtual_min", in.groups[g].plannedVirtual_min),
                                        {"planned_real_min", in.groups[g].plannedReal_min}}) {
      if (planned) {
        rows.add(name, planned, allocated);
      }
    }
  }
}

/// Adds who withdrew, and the times noted for each trainee.
void addTrainees(const CohortInputs& in, Ledger& ledger) {
  std::map<std::string, const CohortDose*> doses;
  for (const CohortDose& dose : in.doses) {
    doses[dose.trainee] = &dose;
  }
  for (const CohortTrainee& trainee : in.trainees) {
    ResultWriter rows(ledger, traineeKey(ledger, trainee), commonFlags(in));
    rows.madeOf = partsOf({RecordRef{RecordKind::kEnrolments}});
    rows.put("withdrew", trainee.withdrew, 1);
    if (const auto dose = doses.find(trainee.code); dose != doses.end()) {
      rows.madeOf = partsOf({RecordRef{RecordKind::kTrainingTimes}});
      rows.add("noted_virtual_min", dose->second->virtual_min, 1);
      rows.add("noted_real_min", dose->second->real_min, 1);
      rows.add("noted_rest_min", dose->second->rest_min, 1);
    }
  }
}

/// Adds the times noted and recorded of the groups.
void addTimes(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kPractice}, commonFlags(in));
  std::map<std::string, std::size_t> groupOf;
  for (const CohortTrainee& trainee : in.trainees) {
    groupOf[trainee.code] = trainee.group;
  }
  const auto within = [&](const std::string& trainee, std::size_t group) {
    const auto found = groupOf.find(trainee);
    return found != groupOf.end() && found->second == group;
  };
  std::int64_t withTimes = 0;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    std::int64_t trainees = 0;
    std::int64_t rested = 0;
    CohortDose sum;
    for (const CohortDose& dose : in.doses) {
      if (within(dose.trainee, g)) {
        ++trainees;
        sum.virtual_min += dose.virtual_min;
        sum.real_min += dose.real_min;
        sum.rest_min += dose.rest_min;
        rested += dose.rest_min > 0.0 ? 1 : 0;
      }
    }
    if (trainees == 0) {
      continue;
    }
    double recorded_min = 0.0;
    for (const TrialSummaryRow& trial : in.trials) {
      // An untwisting does not belong to a phase of the study's arms.
      recorded_min += within(trial.trainee, g) && trial.detorsion.empty() ? trial.minutes : 0.0;
    }
    const auto count = static_cast<double>(trainees);
    rows.place.group = rows.group(g);
    const auto noted = [&](const char* statistic) {
      return partsOf({ResultPattern{
          .section = kParticipants, .statistic = statistic, .of = kEach, .group = ledger.group(g)}});
    };
    rows.madeOf = noted("noted_virtual_min");
    rows.add("mean_noted_virtual_min", sum.virtual_min / count, trainees);
    rows.madeOf = noted("noted_real_min");
    rows.add("mean_noted_real_min", sum.real_min / count, trainees);
    rows.madeOf = noted("noted_rest_min");
    rows.addCount("trainees_who_rested", rested, trainees);
    rows.add("rest_min", sum.rest_min, trainees);
    rows.madeOf = partsOf({RecordRef{RecordKind::kTrainingTimes}, runsOf("minutes", rows.place.group)});
    rows.add("mean_recorded_virtual_min", recorded_min / count, trainees);
    withTimes += trainees;
  }
  if (withTimes > 0) {
    rows.place = {.section = kPractice};
    rows.madeOf =
        partsOf({ResultPattern{.section = kParticipants, .statistic = "noted_rest_min", .of = kEach}});
    rows.addCount("trainees_with_times", withTimes, withTimes);
  }
}

/// Adds who was trained as planned.
void addReceived(const CohortInputs& in, Ledger& ledger) {
  std::map<std::size_t, std::map<Received, std::int64_t>> counts;
  std::map<std::size_t, std::int64_t> trainees;
  for (const ReceivedTraining& one : receivedTraining(in)) {
    ResultWriter rows(ledger, {.section = kParticipants, .of = one.trainee, .group = ledger.group(one.group)},
                      commonFlags(in));
    rows.madeOf = partsOf({RecordRef{RecordKind::kCohortPlan}, RecordRef{RecordKind::kTrainingTimes}});
    rows.put("received", Text(std::string(wordOf(one.received))), 1);
    ++counts[one.group][one.received];
    ++trainees[one.group];
  }
  for (auto& [group, of] : counts) {
    ResultWriter rows(ledger, {.section = kParticipants, .group = ledger.group(group)}, commonFlags(in));
    rows.madeOf = partsOf({ResultPattern{
        .section = kParticipants, .statistic = "received", .of = kEach, .group = ledger.group(group)}});
    for (const Received received : kEveryReceived) {
      rows.addCount(receivedStatistic(received), of[received], trainees[group]);
    }
  }
}

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

ResultKey traineeKey(const Ledger& ledger, const CohortTrainee& trainee) {
  return {.section = kParticipants, .of = trainee.code, .group = ledger.group(trainee.group)};
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

void addPracticeResults(const CohortInputs& in, const CohortInputs& all, Ledger& ledger) {
  if (!in.trainees.empty()) {
    addParticipants(in, all, ledger);
    addTrainees(in, ledger);
    addReceived(in, ledger);
  }
  addTimes(in, ledger);
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
  addRunsByPhase(in, ledger);
  addMediansByPhase(in, RunKind::kUntwisting, ledger);
  addMediansByPhase(in, RunKind::kForeign, ledger);
  addRunCounts(in, ledger);
  addForeignCourses(in, ledger);
}

}  // namespace torsio
