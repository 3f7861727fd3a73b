// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/training/attempts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "app/training/trainee_record.h"
#include "assessment/metrics/metric_cards.h"
#include "assessment/statistics/quantiles.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

constexpr const char* kTwists = "twists";
constexpr const char* kDuration = "duration_s";
constexpr std::int64_t kMostAttempts = 10'000;

/// Mishaps of all twists add up, and of a largest value the largest counts; else the middle one does.
constexpr std::array<std::string_view, 6> kSummed{"twist.excursions",     "force.violations",
                                                  "force.violation_time", "force.excess",
                                                  "torque.violations",    "shear.over_limit"};
constexpr std::array<std::string_view, 4> kLargest{"force.peak", "force.peak_raw", "torque.peak",
                                                   "force.rate"};

template <std::size_t N>
bool isOneOf(const std::array<std::string_view, N>& ids, std::string_view id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

double overTwists(std::string_view id, const std::vector<double>& values) {
  if (isOneOf(kLargest, id)) return *std::max_element(values.begin(), values.end());
  if (!isOneOf(kSummed, id)) return quantile(values, 0.5).value();
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

/// The values that were kept beside the trial; false when there are none of this version.
bool readKept(const std::vector<StoredTrialEvent>& events, Attempt& attempt) {
  bool found = false;
  for (const StoredTrialEvent& event : events) {
    if (event.kind != kMetricsVersion || !event.value) continue;
    found = true;
    if (event.label == kTwists) {
      attempt.twists = std::llround(*event.value);
    } else if (event.label == kDuration) {
      attempt.duration_s = *event.value;
    } else {
      attempt.values[event.label] = *event.value;
    }
  }
  const auto reached = attempt.values.find(kTargetsReachedMetric);
  if (reached != attempt.values.end()) attempt.onTarget = std::llround(reached->second);
  return found;
}

void keep(TrialRepository& trials, const std::string& trialId, const std::vector<StoredTrialEvent>& before,
          const Attempt& attempt) {
  std::int64_t sequence = before.empty() ? 0 : before.back().sequence;
  std::vector<StoredTrialEvent> events;
  const auto add = [&](const std::string& label, double value) {
    events.push_back({.sequence = ++sequence, .kind = kMetricsVersion, .label = label, .value = value});
  };
  add(kTwists, static_cast<double>(attempt.twists));
  add(kDuration, attempt.duration_s);
  for (const auto& [id, value] : attempt.values) add(id, value);
  trials.addEvents(trialId, events);
}

/// `module` may be null: then the pattern's usual tolerance counts, and no limit.
Attempt measured(TrialRepository& trials, const TrialListing& listing, const StoredModule* module) {
  Attempt attempt;
  const std::vector<StoredTrialEvent> events = trials.events(listing.trialId);
  if (listing.summary && !readKept(events, attempt)) {
    const Trial trial = trials.load(listing.trialId);
    const StoredModule standard;
    const StoredModule& rules = module != nullptr ? *module : standard;
    attempt = measureAttempt(trial.header, decodeTrial(trial), rules.tolerance_rad, rules.maxForce_N,
                             rules.maxTorque_Nm);
    keep(trials, listing.trialId, events, attempt);
  }
  attempt.trialId = listing.trialId;
  attempt.moduleId = listing.moduleId;
  attempt.phaseId = listing.phaseId;
  attempt.mode = listing.attemptMode;
  attempt.startedUtc_us = listing.startedUtc_us;
  attempt.ended = listing.summary.has_value();
  attempt.interrupted = listing.summary && listing.summary->outcome == TrialOutcome::kInterrupted;
  return attempt;
}

}  // namespace

bool cutOff(const MeasuredTwist& twist, std::span<const Sample> samples) {
  return twist.firstSample + twist.samples == samples.size() &&
         samples.back().phase == ExercisePhase::kTwisting;
}

Attempt measureAttempt(const TrialHeader& header, std::span<const Sample> samples, double tolerance_rad,
                       std::optional<double> forceLimit_N, std::optional<double> torqueLimit_Nm) {
  if (samples.size() < 2) return attemptFrom(header, samples, {}, tolerance_rad);
  TrialMeasurement options;
  options.tolerance_rad = tolerance_rad;
  options.forceLimit_N = forceLimit_N;
  options.wholeTrial = false;
  options.torqueLimit_Nm = torqueLimit_Nm;
  return attemptFrom(header, samples, measureRecordedTrial(header, samples, options), tolerance_rad);
}

Attempt attemptFrom(const TrialHeader& header, std::span<const Sample> samples, const MeasuredTrial& measured,
                    double tolerance_rad) {
  Attempt attempt;
  attempt.trialId = header.trialId;
  attempt.startedUtc_us = header.startedUtc_us;
  attempt.duration_s = static_cast<double>(samples.size()) * static_cast<double>(header.tickPeriod_us) * 1e-6;
  attempt.values[kTargetsReachedMetric] = 0.0;
  if (samples.size() < 2) return attempt;
  std::map<std::string_view, std::vector<double>> ofTwists;
  for (const MeasuredTwist& twist : measured.twists) {
    if (cutOff(twist, samples)) continue;
    ++attempt.twists;
    if (std::abs(twist.releasedAt_rad - twist.target_rad) <= tolerance_rad) ++attempt.onTarget;
    if (!twist.metrics) continue;
    for (const MetricValue& metric : twist.metrics->values) {
      if (metric.value) ofTwists[metric.id].push_back(*metric.value);
    }
  }
  for (const auto& [id, values] : ofTwists) attempt.values[std::string(id)] = overTwists(id, values);
  attempt.values[kTargetsReachedMetric] = static_cast<double>(attempt.onTarget);
  if (attempt.twists > 0) {
    attempt.values[kOnTargetMetric] =
        static_cast<double>(attempt.onTarget) / static_cast<double>(attempt.twists);
  }
  return attempt;
}

void keepAttempt(TrialRepository& trials, const std::string& trialId, const Attempt& attempt) {
  const std::vector<StoredTrialEvent> events = trials.events(trialId);
  Attempt before;
  if (!readKept(events, before)) keep(trials, trialId, events, attempt);
}

Attempt attemptOf(Workplace& workplace, const std::string& trialId) {
  const TraineeRecord record = ownRecord(workplace, Operation::kTrialViewOwn);
  TrialRepository trials(workplace.connection());
  const TrialListing listing = ownTrial(workplace, record, trialId);
  Transaction transaction(workplace.connection());
  Attempt attempt = measured(trials, listing, record.module(listing.moduleId));
  transaction.commit();
  return attempt;
}

std::vector<Attempt> attemptsOf(Workplace& workplace, const std::string& personId,
                                const std::string& moduleId) {
  workplace.requireOwn(Operation::kTrialViewOwn, personId);
  const TraineeRecord record = ownRecord(workplace, Operation::kTrialViewOwn);
  TrialRepository trials(workplace.connection());
  TrialFilter filter;
  filter.traineeCode = record.code;
  filter.moduleId = moduleId;
  filter.limit = kMostAttempts;
  std::vector<Attempt> attempts;
  Transaction transaction(workplace.connection());
  for (const TrialListing& listing : trials.list(filter)) {
    attempts.push_back(measured(trials, listing, record.module(listing.moduleId)));
  }
  transaction.commit();
  std::reverse(attempts.begin(), attempts.end());
  return attempts;
}

bool counts(const Attempt& attempt, const StoredModule& module) {
  return attempt.ended && !attempt.interrupted && attempt.moduleId == module.id &&
         (attempt.mode == AttemptMode::kGraded || module.mode == AttemptMode::kPractice);
}

bool reaches(const StoredMasteryRule& rule, double value) noexcept {
  return rule.comparison == "at_most" ? value <= rule.threshold : value >= rule.threshold;
}

std::vector<RuleProgress> ruleProgress(const StoredModule& module, std::span<const Attempt> attempts) {
  std::vector<RuleProgress> progress;
  for (const StoredMasteryRule& rule : module.mastery) {
    RuleProgress p;
    p.rule = rule;
    for (const Attempt& attempt : attempts) {
      if (!counts(attempt, module)) continue;
      const auto value = attempt.values.find(rule.metric);
      p.last = value == attempt.values.end() ? std::nullopt : std::optional(value->second);
      p.streak = p.last && reaches(rule, *p.last) ? p.streak + 1 : 0;
      p.met = p.met || p.streak >= rule.consecutive;
    }
    progress.push_back(std::move(p));
  }
  return progress;
}

}  // namespace torsio
