// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/competence.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "assessment/attempt/trial_digest.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/ids.h"
#include "assessment/results/number_format.h"
#include "db/connection/connection.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/angle.h"

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

std::string percentText(double share) {
  constexpr double kLeast = 0.0005;
  const std::string number = share < kLeast ? "<\u00A00.1" : formatFixed(100.0 * share, 1);
  return number + "\u00A0%";  // a no-break space before the sign
}

namespace {

/// Describes a success: "a twist released within 10.0 degrees (tolerance of the exercise), with a force of at
/// most 3.30 N, in a run that was finished".
Text successText(const CompetenceRule& rule) {
  const CompetenceDesign& design = rule.design;
  Text success = rule.untwisting
                     ? Text(Text::tr("an untwisting that passes"))
                     : Text::tr("a twist released within %1 {degree|degrees} (tolerance %2)",
                                formatFixed(degrees(design.tolerance_rad), 1), Text(labelOf(design.source)));
  if (rule.forceLimit_N) {
    success = Text::tr("%1, with a force of at most %2", success,
                       shownValue(Quantity::kPeakForce, *rule.forceLimit_N));
  }
  if (rule.torqueLimit_Nm) {
    success = Text::tr("%1, with a torque of at most %2", success,
                       shownValue(Quantity::kPeakTorque, *rule.torqueLimit_Nm));
  }
  return Text::tr("%1, in a run that was finished", success);
}

}  // namespace

Text competenceRuleText(const CompetenceRule& rule) {
  const CompetenceDesign& design = rule.design;
  const Text which =
      design.version > 0
          ? Text::tr("Competence design, version %1", design.version)
          : Text::tr(
                "Competence design shipped with the exercise (none was registered before the first attempt)");
  return Text::tr(
      "%1: success is %2; competent once the LC-CUSUM of failure rates %3 against %4 reaches %5, planned for "
      "%6 "
      "{attempt|attempts}.",
      which, successText(rule), percentText(design.adequate), percentText(design.inadequate),
      formatFixed(design.limit, 2), design.attempts);
}

Text competenceErrorText(const CompetenceDesign& design, const CompetenceErrors& errors) {
  return Text::tr(
      "Within %1 {attempt|attempts}, %2 of trainees who fail %3 of their attempts are judged competent "
      "(false "
      "pass), and %4 of those who fail only %5 are not (false fail); another %6 lose it through a false "
      "alarm.",
      errors.attempts, percentText(errors.falsePass), percentText(design.inadequate),
      percentText(errors.falseFail), percentText(design.adequate), percentText(errors.falseAlarm));
}

Text competenceLevelText(const CompetenceVerdict& verdict) {
  switch (verdict.level) {
    case SkillLevel::kNotShown:
      return Text::tr("not shown yet; %1 more {attempt|attempts} needed", verdict.attemptsUntilLevel);
    case SkillLevel::kLearning:
      return Text::tr("learning");
    case SkillLevel::kSteady:
      return Text::tr("competent since attempt %1", verdict.ableAt.value_or(0));
    case SkillLevel::kWatch:
      return Text::tr("competent since attempt %1; the latest attempts raise doubts",
                      verdict.ableAt.value_or(0));
    case SkillLevel::kRelapsed:
      return Text::tr("competent at attempt %1, but not now", verdict.ableAt.value_or(0));
  }
  return {};
}

}  // namespace torsio
