// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/training/trend.h"

#include <algorithm>
#include <cmath>

#include "app/training/trainee_record.h"
#include "assessment/metrics/metric_cards.h"
#include "assessment/statistics/curve_fit.h"
#include "assessment/statistics/cusum.h"
#include "assessment/study/curriculum.h"
#include "sim/base/error.h"
#include "sim/base/ids.h"

namespace torsio {

namespace {

// A trainee who fails one attempt in ten is able, one who fails three in ten is not. With this limit somebody
// who never fails is shown to be able after five attempts; the second failure soon after that is an alarm.
constexpr LcCusumDesign kDesign{.adequate = 0.1, .inadequate = 0.3, .limit = 1.25};
constexpr double kWatchShare = 0.5;
constexpr int kCurvePoints = 60;

bool passedAll(const TrainingModule& module, const Attempt& attempt) {
  std::vector<MasteryRule> rules;
  for (const MasteryCriterion& rule : module.mastery) {
    rules.push_back(masteryRule(rule));
  }
  return meetsDemands(demandsOf(module), attempt.values, attempt.twists) &&
         passesAll(rules, attempt.values, attempt.onTarget, attempt.twists);
}

void describeMetric(Trend& trend) {
  if (trend.metric == kOnTargetMetric || trend.metric == kTargetsReachedMetric) {
    trend.unit = trend.metric == kOnTargetMetric ? "1" : "count";
    trend.lowerIsBetter = false;
    return;
  }
  for (const MetricCard& card : metricCards()) {
    if (card.id != trend.metric) {
      continue;
    }
    trend.unit = std::string(card.unit);
    trend.lowerIsBetter = card.direction != Direction::kHigherIsBetter;
  }
}

void fitCurve(Trend& trend) {
  if (isAnswerMetric(trend.metric)) {
    trend.noCurveReason = "a yes or no has no learning curve";
    return;
  }
  std::vector<double> attempt;
  std::vector<double> value;
  for (const TrendPoint& point : trend.points) {
    if (!point.value) {
      continue;
    }
    attempt.push_back(static_cast<double>(point.attempt));
    value.push_back(*point.value);
  }
  const bool positive = std::all_of(value.begin(), value.end(), [](double v) { return v >= 0.0; });
  const auto exponential = fitLearningCurve(LearningFamily::kExponential, attempt, value, positive);
  const auto power = fitLearningCurve(LearningFamily::kPower, attempt, value, positive);
  if (!exponential && !power) {
    trend.noCurveReason = exponential.reason().str();
    return;
  }
  const bool usePower = power && (!exponential || power->fit.aicc < exponential->fit.aicc);
  const LearningCurve& curve = usePower ? *power : *exponential;
  trend.asymptote = curve.asymptote;
  const double last = attempt.back();
  for (int i = 0; i <= kCurvePoints; ++i) {
    const double at = 1.0 + (last - 1.0) * static_cast<double>(i) / kCurvePoints;
    const Interval band = learningBandAt(curve, at);
    trend.curve.push_back({at, learningCurveAt(curve, at), band.lower, band.upper});
  }
}

void measureDistance(Trend& trend, const TrainingModule& module) {
  for (const MasteryCriterion& rule : module.mastery) {
    if (rule.metric != trend.metric) {
      continue;
    }
    trend.threshold = rule.threshold;
    trend.lowerIsBetter = rule.comparison == "at_most";
  }
  const auto last = std::find_if(trend.points.rbegin(), trend.points.rend(),
                                 [](const TrendPoint& point) { return point.value.has_value(); });
  if (!trend.threshold || last == trend.points.rend()) {
    return;
  }
  trend.distance = trend.lowerIsBetter ? *last->value - *trend.threshold : *trend.threshold - *last->value;
}

/// Whether the organ of a module comes twisted, as far as its rules and its attempts tell.
bool isUndone(const TrainingModule& module, const std::vector<Attempt>& attempts) {
  return std::any_of(attempts.begin(), attempts.end(), isUntwisting) ||
         std::any_of(module.mastery.begin(), module.mastery.end(),
                     [](const MasteryCriterion& rule) { return isDetorsionMetric(rule.metric); });
}

/// What a module is followed by unless somebody chooses: what its rules ask for, how much before whether.
/// Without rules it is whether the organ was undone where it came twisted, else the share of twists on
/// target.
std::string usualMetric(const TrainingModule& module, bool untwisting) {
  for (const MasteryCriterion& rule : module.mastery) {
    if (!isAnswerMetric(rule.metric)) {
      return rule.metric;
    }
  }
  if (!module.mastery.empty()) {
    return module.mastery.front().metric;
  }
  return untwisting ? kDetorsionDoneMetric : kOnTargetMetric;
}

}  // namespace

LevelCourse levelCourse(const std::vector<bool>& failed) {
  LevelCourse course;
  course.limit = kDesign.limit;
  bool relapsed = false;
  auto from = failed.begin();
  while (from != failed.end()) {
    const std::vector<bool> rest(from, failed.end());
    const LcCusum learning = lcCusum(rest, kDesign);
    const std::size_t until = learning.competentAt.value_or(rest.size());
    course.sums.insert(course.sums.end(), learning.sums.begin(),
                       learning.sums.begin() + static_cast<std::ptrdiff_t>(until));
    if (!learning.competentAt) {
      course.level = relapsed ? SkillLevel::kRelapsed : SkillLevel::kLearning;
      break;
    }
    if (!course.ableAt) {
      course.ableAt = course.sums.size();
    }
    course.level = SkillLevel::kSteady;
    const std::vector<bool> after(from + static_cast<std::ptrdiff_t>(until), failed.end());
    const RelapseWatch watch = watchForRelapse(after, kDesign);
    const std::size_t seen = watch.alarmAt.value_or(after.size());
    course.sums.insert(course.sums.end(), watch.sums.begin(),
                       watch.sums.begin() + static_cast<std::ptrdiff_t>(seen));
    relapsed = watch.alarmAt.has_value();
    if (relapsed) {
      course.level = SkillLevel::kRelapsed;
    } else if (seen > 0 && course.sums.back() >= kWatchShare * kDesign.limit) {
      course.level = SkillLevel::kWatch;
    }
    from += static_cast<std::ptrdiff_t>(until + seen);
    if (!relapsed) {
      break;
    }
  }
  if (failed.size() < kRunsForLevel) {
    course.level = SkillLevel::kNotShown;
    course.runsUntilLevel = kRunsForLevel - failed.size();
  }
  return course;
}

Trend trend(SessionContext& session, const PersonId& personId, const ModuleId& moduleId,
            const std::string& metric) {
  session.requireOwn(Operation::kTrialViewOwn, personId);
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  const TrainingModule* module = record.module(moduleId);
  if (module == nullptr) {
    throw Error(ErrorCode::kBadParameter, Text::tr("your curriculum has no such module"), moduleId,
                Text::tr("Choose one from the list"));
  }
  Trend trend;
  trend.moduleId = moduleId;
  trend.moduleTitle = module->title;
  trend.metric = metric;
  const std::vector<Attempt> attempts = attemptsOf(session, personId, moduleId);
  trend.untwisting = isUndone(*module, attempts);
  if (metric.empty()) {
    trend.metric = usualMetric(*module, trend.untwisting);
  }
  describeMetric(trend);
  std::vector<bool> failed;
  for (const Attempt& attempt : attempts) {
    if (!attempt.ended || attempt.interrupted) {
      continue;
    }
    TrendPoint point;
    point.trialId = attempt.trialId;
    point.attempt = static_cast<std::int64_t>(trend.points.size()) + 1;
    point.startedUtc_us = attempt.startedUtc_us;
    point.mode = attempt.mode;
    const auto value = attempt.values.find(trend.metric);
    if (value != attempt.values.end()) {
      point.value = value->second;
    }
    point.counted = counts(attempt, *module);
    point.passed = passedAll(*module, attempt);
    if (point.counted) {
      failed.push_back(!point.passed);
    }
    trend.points.push_back(std::move(point));
  }
  measureDistance(trend, *module);
  fitCurve(trend);
  LevelCourse course = levelCourse(failed);
  trend.level = course.level;
  trend.runsUntilLevel = course.runsUntilLevel;
  trend.cusum = std::move(course.sums);
  trend.ableAt = course.ableAt;
  trend.cusumLimit = course.limit;
  if (module->attemptLimit) {
    trend.attemptsLeft =
        std::max<std::int64_t>(0, *module->attemptLimit - static_cast<std::int64_t>(failed.size()));
  }
  return trend;
}

}  // namespace torsio
