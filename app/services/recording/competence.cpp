// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/competence.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "assessment/attempt/trial_digest.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/ids.h"
#include "assessment/results/number_format.h"
#include "db/connection/connection.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/trial/excuse_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/angle.h"

namespace torsio {

namespace {

constexpr std::int64_t kMaxRuns = 10'000;

/// Returns the runs of a trainee at a module that ended, oldest first.
std::vector<TrialListing> endedRuns(Connection& connection, const std::string& traineeCode,
                                    const TrainingModule& module, std::int64_t lastUtc_us) {
  TrialFilter filter;
  filter.traineeCode = traineeCode;
  filter.moduleId = module.id;
  filter.limit = kMaxRuns;
  std::vector<TrialListing> trials = TrialRepository(connection).list(filter);
  std::reverse(trials.begin(), trials.end());
  std::erase_if(trials, [&](const TrialListing& trial) {
    return !trial.summary || !countsAt(module, trial.attemptMode) || trial.startedUtc_us > lastUtc_us;
  });
  return trials;
}

/// Returns the interrupted runs that do not count, oldest first.
std::vector<TrialId> excusedRuns(Connection& connection, const std::string& traineeCode,
                                 const TrainingModule& module) {
  const ExcuseRepository excuses(connection);
  std::vector<TrialId> out;
  for (const TrialListing& trial :
       endedRuns(connection, traineeCode, module, std::numeric_limits<std::int64_t>::max())) {
    if (trial.summary->outcome == TrialOutcome::kInterrupted && excuses.of(trial.trialId)) {
      out.push_back(trial.trialId);
    }
  }
  return out;
}

CompetenceRun runOf(Connection& connection, const TrialListing& trial, const CompetenceDesign& design,
                    const AttemptRules& required, ExerciseRules& rules, std::int64_t now_us) {
  CompetenceRun run{.outcome = RunOutcome::kInterrupted, .startedUtc_us = trial.startedUtc_us};
  if (trial.summary->outcome != TrialOutcome::kInterrupted) {
    const TrialDigest digest = digestOf(connection, trial, rules, now_us);
    run.outcome = competenceOutcome(design, required, digest.measures, digest.tolerance_rad);
  } else {
    run.excused = ExcuseRepository(connection).of(trial.trialId).has_value();
  }
  return run;
}

}  // namespace

bool asksForUntwisting(const TrainingModule& module) {
  return std::any_of(module.mastery.begin(), module.mastery.end(), [](const MasteryCriterion& rule) {
    const std::optional<Quantity> quantity = quantityOf(rule.metric);
    return quantity && isOfUntwisting(*quantity);
  });
}

bool isRequired(const CurriculumVersion& version, const TrainingModule& module) {
  const auto graded = [](const TrainingModule& one) { return one.mode == AttemptMode::kGraded; };
  return graded(module) || std::none_of(version.modules.begin(), version.modules.end(), graded);
}

bool countsAt(const TrainingModule& module, std::optional<AttemptMode> mode) noexcept {
  return mode == AttemptMode::kGraded || module.mode == AttemptMode::kPractice;
}

CompetenceRule ruleOf(const TrainingModule& module, const CompetenceDesign& design) {
  CompetenceRule rule{.design = design, .untwisting = asksForUntwisting(module), .run = rulesOf(module)};
  rule.run.tolerance_rad = design.tolerance_rad;
  return rule;
}

CompetenceVerdict competenceOf(Connection& connection, const std::string& traineeCode,
                               const TrainingModule& module, ExerciseRules& rules, std::int64_t now_us,
                               std::int64_t lastUtc_us) {
  const std::vector<TrialListing> trials = endedRuns(connection, traineeCode, module, lastUtc_us);
  const CompetenceDesign design =
      designInForce(CompetenceRepository(connection).ofModule(module.id),
                    shippedCompetence(module.id, module.tolerance_rad),
                    trials.empty() ? std::nullopt : std::optional(trials.front().startedUtc_us));
  const CompetenceRule rule = ruleOf(module, design);
  std::vector<bool> failed;
  std::vector<TrialId> ids;
  std::vector<std::int64_t> started_us;
  for (const TrialListing& trial : trials) {
    const std::optional<bool> one = runOf(connection, trial, design, rule.run, rules, now_us).failed();
    if (one) {
      failed.push_back(*one);
      ids.push_back(trial.trialId);
      started_us.push_back(trial.startedUtc_us);
    }
  }
  const std::size_t first = firstValidAttempt(design, failed, started_us);
  const auto from = static_cast<std::ptrdiff_t>(first);
  CompetenceVerdict verdict = judgeCompetence(design, {failed.begin() + from, failed.end()});
  verdict.runs = {ids.begin() + from, ids.end()};
  verdict.expiredRuns = first;
  if (isAble(verdict.level) && isExpired(design, started_us.back(), std::min(now_us, lastUtc_us))) {
    verdict.level = SkillLevel::kExpired;
  }
  static_cast<CompetenceRule&>(verdict) = rule;
  return verdict;
}

EstimatedDependence centreDependence(Connection& connection, const TrainingModule& module,
                                     ExerciseRules& rules, std::int64_t now_us) {
  TrialFilter filter;
  filter.moduleId = module.id;
  filter.limit = kMaxRuns;
  std::set<std::string> trainees;
  for (const TrialListing& trial : TrialRepository(connection).list(filter)) {
    trainees.insert(trial.traineeCode);
  }
  const CompetenceDesign design = shippedCompetence(module.id, module.tolerance_rad);
  const AttemptRules required = rulesOf(module);
  std::vector<SessionOutcomes> people;
  for (const std::string& trainee : trainees) {
    std::vector<CompetenceRun> runs;
    for (const TrialListing& trial :
         endedRuns(connection, trainee, module, std::numeric_limits<std::int64_t>::max())) {
      runs.push_back(runOf(connection, trial, design, required, rules, now_us));
    }
    people.push_back(sessionsOf(runs));
  }
  return estimateDependence(people);
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
      if (verdict.attempts == 0 && !isRequired(*version, module)) {
        continue;
      }
      CohortCompetence one;
      one.trainee = trainee.code;
      one.group = trainee.group;
      one.exercise = module.title;
      one.attempts = static_cast<std::int64_t>(verdict.attempts);
      one.failed = static_cast<std::int64_t>(verdict.failed);
      one.level = competenceLevelText(verdict);
      one.ableAt = verdict.ableAt ? std::optional(static_cast<std::int64_t>(*verdict.ableAt)) : std::nullopt;
      one.able = isAble(verdict.level);
      one.required = isRequired(*version, module);
      one.sums = verdict.sums;
      one.runs = verdict.runs;
      one.excused = excusedRuns(connection, trainee.code, module);
      one.limit = verdict.design.limit;
      one.falsePass = verdict.errors.falsePass;
      one.falseFail = verdict.errors.falseFail;
      one.falseAlarm = verdict.errors.falseAlarm;
      one.declaredWithinMade = verdict.made.declared;
      one.declaredWithinPlanned = verdict.planned.declared;
      one.plannedAttempts = verdict.design.attempts;
      one.fewestAttempts = static_cast<std::int64_t>(fewestForAble(verdict.design));
      one.designVersion = verdict.design.version;
      one.design = competenceRuleText(verdict);
      one.errors = competenceErrorText(verdict.design);
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

/// Describes what a run needs to pass: "at least 5 twists, four in five of them released within 10.0 degrees
/// (tolerance of the exercise), a force of at most 3.30 N".
Text successText(const CompetenceRule& rule) {
  const CompetenceDesign& design = rule.design;
  const AttemptRules& run = rule.run;
  Text needs = Text::tr("the organ untwisted");
  if (!rule.untwisting) {
    needs = Text::tr(
        "at least %1 {twist|twists}, four in five of all twists released within %2 "
        "{degree|degrees} (tolerance %3)",
        run.leastTwists, formatFixed(degrees(design.tolerance_rad), 1), Text(labelOf(design.source)));
    if (run.hold_s > 0.0) {
      needs = Text::tr("%1, each held for %2", needs, shownValue(Quantity::kShortestHold, run.hold_s));
    }
  }
  if (run.forceLimit_N) {
    needs = Text::tr("%1, a force of at most %2", needs, shownValue(Quantity::kPeakForce, *run.forceLimit_N));
  }
  if (run.torqueLimit_Nm) {
    needs =
        Text::tr("%1, a torque of at most %2", needs, shownValue(Quantity::kPeakTorque, *run.torqueLimit_Nm));
  }
  for (const MasteryRule& mastery : run.mastery) {
    if (mastery.quantity != Quantity::kUntwisted) {
      needs = Text::tr("%1; %2", needs, mastery.text());
    }
  }
  return needs;
}

/// Formats one number per stated failure rate: "10, 15, 20, 25 and 30 %".
Text fiveShares(const std::array<double, kStatedFailureRates.size()>& shares, int decimals) {
  std::array<std::string, kStatedFailureRates.size()> shown;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    shown[i] = formatFixed(100.0 * shares[i], decimals);
  }
  return Text::tr("%1, %2, %3, %4 and %5\u00A0%", shown[0], shown[1], shown[2], shown[3], shown[4]);
}

/// Formats a share as a frequency, "about 1 in 41". `first`: in a sentence.
Text oneInText(double share, bool first) {
  constexpr double kLeast = 0.0005;
  constexpr double kFew = 10.0;  // from so many on, in whole people
  if (share < kLeast) {
    return first ? Text(Text::tr("Fewer than 1 in 2000")) : Text(Text::tr("fewer than 1 in 2000"));
  }
  const std::string number = formatFixed(1.0 / share, 1.0 / share < kFew ? 1 : 0);
  return first ? Text::tr("About 1 in %1", number) : Text::tr("about 1 in %1", number);
}

/// Describes what the probabilities of a design assume.
Text assumptionText(const CompetenceDesign& design) {
  const Text origin = design.dependenceRuns > 0
                          ? Text::tr("estimated from %1 {run|runs} of this centre", design.dependenceRuns)
                          : Text::tr("assumed high, until %1 {run|runs} of %2 {person|people} tell",
                                     kMinDependenceAttempts, kMinDependencePeople);
  return Text::tr(
      "This holds for a failure rate that does not change, with correlations of %1 among the runs of one "
      "session of %2 and %3 between successive runs (%4).",
      formatFixed(design.sessionCorrelation, 2), design.runsPerSession, formatFixed(design.lagCorrelation, 2),
      origin);
}

}  // namespace

Text competenceRuleText(const CompetenceRule& rule) {
  const CompetenceDesign& design = rule.design;
  const Text which = design.version > 0 ? Text::tr("Competence design, version %1", design.version)
                                        : Text::tr("Default competence rule");
  const Text whole = Text::tr(
      "%1. A run succeeds with: %2. A twist still held when the run ends counts as missed; an interrupted "
      "run "
      "counts as failed unless it is excused. Competent once the LC-CUSUM of the runs, for failure rates of "
      "%3 against %4, "
      "reaches "
      "%5, planned for %6 {run|runs}; fewer than %7 can never show it.",
      which, successText(rule), percentText(design.adequate), percentText(design.inadequate),
      formatFixed(design.limit, 2), design.attempts, fewestForAble(design));
  return design.validDays == 0
             ? whole
             : Text::tr("%1 Competence expires after %2 {day|days} without a run.", whole, design.validDays);
}

Text competenceChanceText(const CompetenceDesign& design) {
  const CompetenceErrors errors = competenceErrors(design, design.attempts);
  return Text::tr(
      "%1 trainees who fail %2 of their runs are declared competent by chance, and %3 who fail only %4 are "
      "not.",
      oneInText(errors.falsePass, true), percentText(design.inadequate), oneInText(errors.falseFail, false),
      percentText(design.adequate));
}

Text competenceErrorText(const CompetenceDesign& design) {
  const CompetenceErrors errors = competenceErrors(design, design.attempts);
  return Text::tr(
      "Of trainees who truly fail %1 of their runs, %2 are declared competent within the %3 {run|runs} "
      "planned; of those who fail only %4, %5 are not, and another %6 lose it through a false alarm. %7",
      fiveShares(kStatedFailureRates, 0), fiveShares(competenceOdds(design, design.attempts).declared, 1),
      design.attempts, percentText(design.adequate), percentText(errors.falseFail),
      percentText(errors.falseAlarm), assumptionText(design));
}

Text competenceMadeText(const CompetenceVerdict& verdict) {
  return verdict.attempts < fewestForAble(verdict.design)
             ? Text::tr("Within the %1 {run|runs} made nobody can be declared competent.", verdict.attempts)
             : Text::tr("Within the %1 {run|runs} made, %2 of those who fail %3 are declared competent.",
                        verdict.attempts, fiveShares(verdict.made.declared, 1),
                        fiveShares(kStatedFailureRates, 0));
}

Text competenceErrorText(const CompetenceVerdict& verdict) {
  return Text::tr("%1 %2", competenceErrorText(verdict.design), competenceMadeText(verdict));
}

Text competenceLevelText(const CompetenceVerdict& verdict) {
  switch (verdict.level) {
    case SkillLevel::kNotShown:
      return Text::tr("not shown yet; %1 more {run|runs} needed", verdict.attemptsUntilLevel);
    case SkillLevel::kLearning:
      return Text::tr("learning");
    case SkillLevel::kSteady:
      return Text::tr("competent since run %1", verdict.ableAt.value_or(0));
    case SkillLevel::kWatch:
      return Text::tr("competent since run %1; the latest runs raise doubts", verdict.ableAt.value_or(0));
    case SkillLevel::kRelapsed:
      return Text::tr("competent at run %1, but not now", verdict.ableAt.value_or(0));
    case SkillLevel::kExpired:
      return Text::tr("competent at run %1, expired after %2 {day|days} without a run",
                      verdict.ableAt.value_or(0), verdict.design.validDays);
  }
  return {};
}

}  // namespace torsio
