// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/competence.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/services/recording/competence_text.h"
#include "assessment/attempt/trial_digest.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/repository/study/competence_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/trial/trial_repository.h"

namespace torsio {

namespace {

constexpr std::int64_t kMaxRuns = 10'000;

CompetenceRun runOf(const TrainingModule& module, const TrialDigest& digest) {
  const AttemptMeasures& measures = digest.measures;
  CompetenceRun run;
  run.untwisting = isUntwisting(measures.values);
  run.outcome = judgeRun(measures.values, rulesOf(module)).outcome;
  run.withinLimits = withinLimits(
      measures.values, {.forceLimit_N = digest.forceLimit_N, .torqueLimit_Nm = digest.torqueLimit_Nm});
  run.tolerance_rad = digest.tolerance_rad;
  run.twists = measures.twists;
  return run;
}

bool isFinished(const TrialListing& trial) {
  return trial.summary && trial.summary->outcome != TrialOutcome::kInterrupted;
}

}  // namespace

bool asksForUntwisting(const TrainingModule& module) {
  return std::any_of(module.mastery.begin(), module.mastery.end(), [](const MasteryCriterion& rule) {
    const std::optional<Quantity> quantity = quantityOf(rule.metric);
    return quantity && isOfUntwisting(*quantity);
  });
}

bool countsAt(const TrainingModule& module, std::optional<AttemptMode> mode) noexcept {
  return mode == AttemptMode::kGraded || module.mode == AttemptMode::kPractice;
}

CompetenceRule ruleOf(const TrainingModule& module, const CompetenceDesign& design) {
  return {.design = design,
          .untwisting = asksForUntwisting(module),
          .forceLimit_N = module.maxForce_N,
          .torqueLimit_Nm = module.maxTorque_Nm};
}

CompetenceVerdict competenceOf(Connection& connection, const std::string& traineeCode,
                               const TrainingModule& module, ExerciseRules& rules, std::int64_t now_us,
                               std::int64_t lastUtc_us) {
  TrialFilter filter;
  filter.traineeCode = traineeCode;
  filter.moduleId = module.id;
  filter.limit = kMaxRuns;
  std::vector<TrialListing> trials = TrialRepository(connection).list(filter);
  std::reverse(trials.begin(), trials.end());  // oldest first
  std::vector<CompetenceRun> runs;
  std::vector<TrialId> ids;
  std::optional<std::int64_t> began_us;
  for (const TrialListing& trial : trials) {
    if (!isFinished(trial) || !countsAt(module, trial.attemptMode) || trial.startedUtc_us > lastUtc_us) {
      continue;
    }
    began_us = began_us.value_or(trial.startedUtc_us);
    runs.push_back(runOf(module, digestOf(connection, trial, rules, now_us)));
    ids.push_back(trial.trialId);
  }
  const CompetenceDesign design = designInForce(CompetenceRepository(connection).ofModule(module.id),
                                                shippedCompetence(module.id, module.tolerance_rad), began_us);
  CompetenceVerdict verdict = judgeCompetence(design, failedAttempts(design, runs));
  verdict.runs = std::move(ids);
  static_cast<CompetenceRule&>(verdict) = ruleOf(module, design);
  verdict.untwisting |=
      std::any_of(runs.begin(), runs.end(), [](const CompetenceRun& r) { return r.untwisting; });
  return verdict;
}

std::vector<CohortCompetence> competenceOfCohort(Connection& connection, const CurriculumVersionId& versionId,
                                                 const std::vector<CohortTrainee>& trainees,
                                                 ExerciseRules& rules, std::int64_t now_us) {
  const std::optional<CurriculumVersion> version =
      versionId.empty() ? std::nullopt : CurriculumRepository(connection).version(versionId);
  std::vector<CohortCompetence> all;
  if (!version) {
    return all;
  }
  for (const TrainingModule& module : version->modules) {
    for (const CohortTrainee& trainee : trainees) {
      const CompetenceVerdict verdict = competenceOf(connection, trainee.code, module, rules, now_us);
      if (verdict.attempts == 0) {
        continue;
      }
      CohortCompetence one;
      one.trainee = trainee.code;
      one.group = trainee.group;
      one.exercise = module.title;
      one.attempts = std::ssize(verdict.sums);
      one.failed = static_cast<std::int64_t>(verdict.failed);
      one.level = competenceLevelText(verdict);
      one.ableAt = verdict.ableAt ? std::optional(static_cast<std::int64_t>(*verdict.ableAt)) : std::nullopt;
      one.able = isAble(verdict.level);
      one.sums = verdict.sums;
      one.runs = verdict.runs;
      one.limit = verdict.design.limit;
      one.falsePass = verdict.errors.falsePass;
      one.falseFail = verdict.errors.falseFail;
      one.falseAlarm = verdict.errors.falseAlarm;
      one.withinAttempts = verdict.errors.attempts;
      one.designVersion = verdict.design.version;
      one.design = competenceRuleText(verdict);
      one.errors =
          competenceErrorText(verdict.design, competenceErrors(verdict.design, verdict.design.attempts));
      all.push_back(std::move(one));
    }
  }
  return all;
}

}  // namespace torsio
