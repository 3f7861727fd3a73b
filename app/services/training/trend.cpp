// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/trend.h"

#include <algorithm>
#include <cmath>

#include "app/services/recording/competence.h"
#include "app/services/recording/kept_digests.h"
#include "app/services/training/trainee_record.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/statistics/curve_fit.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr int kCurvePoints = 60;

void fitCurve(Trend& trend) {
  if (isAnswer(trend.quantity)) {
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
  for (const MasteryCriterion& stored : module.mastery) {
    if (const MasteryRule rule = masteryRule(stored); rule.quantity == trend.quantity) {
      trend.threshold = rule.threshold;
      trend.lowerIsBetter = rule.atMost;
    }
  }
  const auto last = std::find_if(trend.points.rbegin(), trend.points.rend(),
                                 [](const TrendPoint& point) { return point.value.has_value(); });
  if (!trend.threshold || last == trend.points.rend()) {
    return;
  }
  trend.distance = trend.lowerIsBetter ? *last->value - *trend.threshold : *trend.threshold - *last->value;
}

/// Returns whether a module's organ starts twisted, judging by its rules and attempts.
bool isUndone(const TrainingModule& module, const std::vector<Attempt>& attempts) {
  return std::any_of(attempts.begin(), attempts.end(),
                     [](const Attempt& attempt) { return attempt.ended && isUntwisting(attempt.values); }) ||
         asksForUntwisting(module);
}

/// Returns the default metric of a module: from its rules, quantities before yes/no metrics. Without rules:
/// whether the organ was untwisted, or the share of twists on target.
Quantity usualQuantity(const TrainingModule& module, bool untwisting) {
  std::optional<Quantity> answer;
  for (const MasteryCriterion& stored : module.mastery) {
    const std::optional<Quantity> asked = masteryRule(stored).quantity;
    if (asked && !isAnswer(*asked)) {
      return *asked;
    }
    answer = answer ? answer : asked;
  }
  return answer.value_or(untwisting ? Quantity::kUntwisted : Quantity::kOnTarget);
}

/// Returns the quantities to choose from: those usual for trends, and those in the module's rules.
std::vector<Quantity> offeredFor(const TrainingModule& module, bool untwisting) {
  std::vector<Quantity> offered;
  for (const QuantityRow& row : quantityRows()) {
    const bool usual = row.traits.inTrend && (row.scope == QuantityScope::kUntwisting) == untwisting;
    const bool asked =
        std::any_of(module.mastery.begin(), module.mastery.end(),
                    [&row](const MasteryCriterion& stored) { return stored.metric == row.id; });
    if (usual || asked) {
      offered.push_back(row.quantity);
    }
  }
  return offered;
}

}  // namespace

Trend trend(SessionContext& session, const PersonId& personId, const ModuleId& moduleId,
            std::optional<Quantity> quantity) {
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
  const std::vector<Attempt> attempts = attemptsOf(session, personId, moduleId);
  trend.untwisting = isUndone(*module, attempts);
  trend.quantity = quantity.value_or(usualQuantity(*module, trend.untwisting));
  trend.offered = offeredFor(*module, trend.untwisting);
  trend.lowerIsBetter = rowOf(trend.quantity).direction != Direction::kHigherIsBetter;
  std::int64_t made = 0;
  for (const Attempt& attempt : attempts) {
    if (!attempt.ended || attempt.interrupted()) {
      continue;
    }
    TrendPoint point;
    point.trialId = attempt.trialId;
    point.attempt = static_cast<std::int64_t>(trend.points.size()) + 1;
    point.startedUtc_us = attempt.startedUtc_us;
    point.mode = attempt.mode;
    point.value = valueIn(attempt.values, trend.quantity);
    point.counted = counts(attempt, *module);
    point.outcome = attempt.verdict.outcome;
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
