// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/attempts.h"

#include <algorithm>

#include "app/services/recording/competence.h"
#include "app/services/recording/kept_digests.h"
#include "app/services/training/trainee_record.h"
#include "assessment/attempt/foreign_measures.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/repository/trial/excuse_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

constexpr std::int64_t kMaxAttempts = 10'000;

Attempt measured(SessionContext& session, const TrialListing& listing, ExerciseRules& rules) {
  Attempt attempt;
  if (listing.summary) {
    const AttemptMeasures measures =
        digestOf(session.connection(), listing, rules, session.now_us()).measures;
    attempt.duration_s = static_cast<double>(measures.duration_us) * 1e-6;
    attempt.twists = std::ssize(measures.twists);
    attempt.onTarget = measures.twistsOnTarget();
    attempt.unfinished = measures.unfinished;
    attempt.values = measures.values;
    attempt.verdict =
        verdictOn(*listing.summary, measures,
                  rules.of(session.connection(), listing.sceneId, listing.patternId, listing.moduleId));
  }
  attempt.excused =
      attempt.interrupted() && ExcuseRepository(session.connection()).of(listing.trialId).has_value();
  attempt.trialId = listing.trialId;
  attempt.moduleId = listing.moduleId;
  attempt.phaseId = listing.phaseId;
  attempt.mode = listing.attemptMode;
  attempt.startedUtc_us = listing.startedUtc_us;
  attempt.ended = listing.summary.has_value();
  attempt.forceCuts = listing.summary && listing.summary->health ? listing.summary->health->forceCuts : 0;
  return attempt;
}

}  // namespace

std::vector<Attempt> attemptsOf(SessionContext& session, const PersonId& personId, const ModuleId& moduleId) {
  session.requireOwn(Operation::kTrialViewOwn, personId);
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  TrialRepository trials(session.connection());
  TrialFilter filter;
  filter.traineeCode = record.code;
  filter.moduleId = moduleId;
  filter.limit = kMaxAttempts;
  std::vector<Attempt> attempts;
  ExerciseRules rules;
  Transaction transaction(session.connection());
  for (const TrialListing& listing : trials.list(filter)) {
    if (!isForeign(listing.sceneId)) {  // recordings on the real arm are not attempts at modules
      attempts.push_back(measured(session, listing, rules));
    }
  }
  transaction.commit();
  std::reverse(attempts.begin(), attempts.end());
  return attempts;
}

std::vector<RealArmRun> realArmRuns(SessionContext& session, const PersonId& personId) {
  session.requireOwn(Operation::kTrialViewOwn, personId);
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  TrialFilter filter;
  filter.traineeCode = record.code;
  filter.sceneId = SceneId(std::string(kForeignScene));
  filter.limit = kMaxAttempts;
  std::vector<RealArmRun> runs;
  ExerciseRules rules;
  Transaction transaction(session.connection());
  for (const TrialListing& listing : TrialRepository(session.connection()).list(filter)) {
    if (listing.summary) {
      const AttemptMeasures measures =
          digestOf(session.connection(), listing, rules, session.now_us()).measures;
      runs.push_back({listing.trialId, listing.startedUtc_us,
                      static_cast<double>(measures.duration_us) * 1e-6, foreignSentences(measures.values)});
    }
  }
  transaction.commit();
  std::reverse(runs.begin(), runs.end());
  return runs;
}

Text Attempt::result() const {
  if (!isUntwisting(values)) {
    return Text::tr("%1 of %2 on target", onTarget, twists);
  }
  const std::optional<double> done = valueIn(values, Quantity::kUntwisted);
  if (!done) {
    return Text::tr("not measured");
  }
  const Text dose = shownValue(Quantity::kDose, valueIn(values, Quantity::kDose));
  if (*done == 0.0) {
    return Text::tr("not untwisted, ischaemic dose %1", dose);
  }
  constexpr double kAtOnce_s = 0.05;  // blood flowed from the start
  const std::optional<double> flow_s = valueIn(values, Quantity::kTimeToFlow);
  return flow_s && *flow_s >= kAtOnce_s ? Text::tr("untwisted, blood after %1, ischaemic dose %2",
                                                   shownValue(Quantity::kTimeToFlow, *flow_s), dose)
                                        : Text::tr("untwisted, ischaemic dose %1", dose);
}

Text RuleProgress::text() const {
  const Text goal = rule.text();
  if (rule.consecutive <= 1) {
    return goal;
  }
  return met ? Text::tr("%1, in %2 {run|runs} in a row", goal, rule.consecutive)
             : Text::tr("%1, in %2 {run|runs} in a row (%3 so far)", goal, rule.consecutive, streak);
}

bool counts(const Attempt& attempt, const TrainingModule& module) {
  return attempt.ended && !attempt.interrupted() && attempt.moduleId == module.id &&
         countsAt(module, attempt.mode);
}

std::vector<RuleProgress> ruleProgress(const TrainingModule& module, std::span<const Attempt> attempts) {
  std::vector<RuleProgress> progress;
  for (const MasteryCriterion& stored : module.mastery) {
    const MasteryRule rule = masteryRule(stored);
    std::vector<std::optional<double>> values;
    for (const Attempt& attempt : attempts) {
      if (counts(attempt, module)) {
        const bool valid = rule.quantity && meetsDemands(attempt.values, rulesOf(module));
        values.push_back(valid ? valueIn(attempt.values, *rule.quantity) : std::nullopt);
      } else if (attempt.interrupted() && !attempt.excused && attempt.moduleId == module.id &&
                 countsAt(module, attempt.mode)) {
        values.emplace_back();
      }
    }
    const MasteryProgress reached = masteryProgress(rule, values);
    progress.push_back({rule, reached.streak, reached.met, reached.last});
  }
  return progress;
}

}  // namespace torsio
