// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/trend.h"

#include <algorithm>
#include <cmath>

#include "app/services/recording/competence.h"
#include "app/services/recording/kept_digests.h"
#include "app/services/training/trainee_record.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/metrics/metric_cards.h"
#include "assessment/statistics/curve_fit.h"
#include "sim/core/refusal.h"

namespace torsio {

namespace {

constexpr int kCurvePoints = 60;

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
  return std::any_of(attempts.begin(), attempts.end(), isUntwisting) || asksForUntwisting(module);
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

Trend trend(SessionContext& session, const PersonId& personId, const ModuleId& moduleId,
            const std::string& metric) {
  session.requireOwn(Operation::kTrialViewOwn, personId);
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  const TrainingModule* module = record.module(moduleId);
  if (module == nullptr) {
    refuseParameter(Text::tr("your curriculum has no such module"), moduleId,
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
  std::int64_t made = 0;
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
    point.passed = passesModule(*module, attempt.values, attempt.onTarget, attempt.twists);
    made += point.counted ? 1 : 0;
    trend.points.push_back(std::move(point));
  }
  measureDistance(trend, *module);
  fitCurve(trend);
  ExerciseRules rules;
  trend.competence = competenceOf(session.connection(), record.code, *module, rules, session.now_us());
  if (module->attemptLimit) {
    trend.attemptsLeft = std::max<std::int64_t>(0, *module->attemptLimit - made);
  }
  return trend;
}

}  // namespace torsio
