// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/competence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/statistics/cusum.h"
#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr double kWatchShare = 0.5;
constexpr double kMaxCorrelation = 0.9;
constexpr std::int64_t kSessionPause_us = kDay_us / 4;

void requireShare(double value, const Text& name) {
  if (!(value > 0.0 && value < 1.0)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("must lie above 0 and below 1"), name,
                Text::tr("Give a share such as 0.05"));
  }
}

void requireCorrelation(double value, const Text& name) {
  if (!(value >= 0.0 && value <= kMaxCorrelation)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("must lie between 0 and 0.9"), name,
                Text::tr("Give a correlation such as 0.1; 0 for independent runs"));
  }
}

Text percent(double share) {
  const double tenths = std::round(1000.0 * share);
  return Text::verbatim("%1.%2 %", static_cast<std::int64_t>(tenths) / 10,
                        static_cast<std::int64_t>(tenths) % 10);
}

}  // namespace

LcCusumDesign cusumOf(const CompetenceDesign& design) {
  return {.adequate = design.adequate,
          .inadequate = design.inadequate,
          .limit = design.limit,
          .dependence = {.session = design.sessionCorrelation,
                         .lag = design.lagCorrelation,
                         .perSession = design.runsPerSession}};
}

void requireSoundNumbers(const CompetenceDesign& design) {
  requireShare(design.adequate, Text::tr("adequate failure rate"));
  requireShare(design.inadequate, Text::tr("inadequate failure rate"));
  requireShare(design.falsePassMost, Text::tr("largest false pass"));
  requireShare(design.falseFailMost, Text::tr("largest false fail"));
  if (!(design.inadequate > design.adequate)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("must be greater than the adequate one"),
                Text::tr("inadequate failure rate"),
                Text::tr("Give two rates that differ, such as 0.1 and 0.3"));
  }
  if (design.attempts < 1 || design.attempts > kMaxCompetenceAttempts) {
    throw Error(ErrorCode::kBadParameter, Text::tr("must lie between 1 and %1", kMaxCompetenceAttempts),
                Text::tr("number of runs"), Text::tr("Give as many as a trainee makes, such as 50"));
  }
  requireCorrelation(design.sessionCorrelation, Text::tr("correlation of the runs of a session"));
  requireCorrelation(design.lagCorrelation, Text::tr("correlation of successive runs"));
  if (design.runsPerSession < 1 || design.runsPerSession > kMaxCompetenceAttempts) {
    throw Error(ErrorCode::kBadParameter, Text::tr("must lie between 1 and %1", kMaxCompetenceAttempts),
                Text::tr("runs of a session"), Text::tr("Give as many as a trainee makes in a day"));
  }
  if (design.validDays < 0 || design.validDays > kMaxValidDays) {
    throw Error(ErrorCode::kBadParameter, Text::tr("must lie between 0 and %1", kMaxValidDays),
                Text::tr("days that competence lasts"), Text::tr("Give for example 365; 0 for no end"));
  }
  if (!(design.tolerance_rad > 0.0 && design.tolerance_rad <= std::numbers::pi)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("must lie above 0 and at most at 180 degrees"),
                Text::tr("tolerance"), Text::tr("Give an angle in degrees"));
  }
}

CompetenceErrors competenceErrors(const CompetenceDesign& design, std::int64_t attempts) {
  TORSIO_EXPECTS(attempts >= 0);
  if (attempts == 0) {
    return {};
  }
  const LcCusumDesign cusum = cusumOf(design);
  const auto n = static_cast<std::size_t>(attempts);
  CompetenceErrors errors{.attempts = attempts};
  errors.falsePass = lcCusumProbability(cusum, design.inadequate, n);
  errors.falseFail = 1.0 - lcCusumProbability(cusum, design.adequate, n);
  constexpr std::size_t kLongest = 10'000;  // beyond this, any design that can be met has converged
  errors.falseAlarm = n <= kLongest
                          ? std::max(0.0, lcCusumNotAble(cusum, design.adequate, n) - errors.falseFail)
                          : lcCusumNotAble(cusum, design.adequate, kLongest);
  return errors;
}

double competenceProbability(const CompetenceDesign& design, double failureRate, std::int64_t attempts) {
  TORSIO_EXPECTS(attempts >= 0);
  return attempts == 0 ? 0.0
                       : lcCusumProbability(cusumOf(design), failureRate, static_cast<std::size_t>(attempts));
}

CompetenceOdds competenceOdds(const CompetenceDesign& design, std::int64_t attempts) {
  CompetenceOdds odds{.attempts = attempts};
  for (std::size_t i = 0; i < kStatedFailureRates.size(); ++i) {
    odds.declared[i] = competenceProbability(design, kStatedFailureRates[i], attempts);
  }
  return odds;
}

CompetenceDesign plannedCompetence(CompetenceDesign design) {
  requireSoundNumbers(design);
  const auto n = static_cast<std::size_t>(design.attempts);
  const std::optional<double> limit = chooseLcCusumLimit(cusumOf(design), n, design.falsePassMost);
  if (!limit) {
    throw Error(ErrorCode::kBadParameter, Text::tr("no limit keeps the largest false pass within these runs"),
                Text::tr("competence design"), Text::tr("Plan more runs, or rates that lie farther apart"));
  }
  design.limit = *limit;
  return design;
}

CompetencePreview previewOfCompetence(const CompetenceDesign& design) {
  CompetencePreview preview{.design = plannedCompetence(design)};
  preview.errors = competenceErrors(preview.design, design.attempts);
  preview.falseFailKept = preview.errors.falseFail <= design.falseFailMost;
  return preview;
}

void requireFalseFailKept(const CompetenceDesign& design) {
  const CompetenceErrors errors = competenceErrors(design, design.attempts);
  if (errors.falseFail > design.falseFailMost) {
    throw Error(
        ErrorCode::kBadParameter,
        Text::tr("%1 of the adequate trainees would not pass within %2 {run|runs}; at most %3 are wanted",
                 percent(errors.falseFail), design.attempts, percent(design.falseFailMost)),
        Text::tr("competence design"), Text::tr("Plan more runs, or rates that lie farther apart"));
  }
}

CompetenceDesign shippedCompetence(const ModuleId& moduleId, double tolerance_rad) {
  CompetenceDesign design;
  design.moduleId = moduleId;
  design.tolerance_rad = tolerance_rad;
  return design;
}

CompetenceDesign designInForce(std::span<const CompetenceDesign> registered, const CompetenceDesign& shipped,
                               std::optional<std::int64_t> firstAttemptUtc_us) {
  CompetenceDesign chosen = shipped;
  for (const CompetenceDesign& design : registered) {
    if (!firstAttemptUtc_us || design.registeredUtc_us <= *firstAttemptUtc_us) {
      chosen = design;
    }
  }
  return chosen;
}

std::optional<bool> CompetenceRun::failed() const noexcept {
  switch (outcome) {
    case RunOutcome::kPassed:
      return false;
    case RunOutcome::kNotPassed:
      return true;
    case RunOutcome::kInterrupted:
      return excused ? std::nullopt : std::optional(true);
    case RunOutcome::kNotJudged:
    case RunOutcome::kRefused:
      break;
  }
  return std::nullopt;
}

RunOutcome competenceOutcome(const CompetenceDesign& design, const AttemptRules& rules,
                             const AttemptMeasures& measures, double measured_rad) {
  if (measured_rad == design.tolerance_rad || isUntwisting(measures.values)) {
    return judgeRun(measures, rules).outcome;
  }
  AttemptMeasures judged = measures;
  const double tolerance_deg = degrees(design.tolerance_rad);
  for (JudgedTwist& twist : judged.twists) {
    twist.onTarget = twist.error_deg <= tolerance_deg;
  }
  const auto reached = static_cast<double>(judged.twistsOnTarget());
  judged.values[Quantity::kTargetsReached] = reached;
  if (!judged.twists.empty()) {
    judged.values[Quantity::kOnTarget] = reached / static_cast<double>(judged.twists.size());
  }
  return judgeRun(judged, rules).outcome;
}

std::vector<bool> failedAttempts(std::span<const CompetenceRun> runs) {
  std::vector<bool> failed;
  for (const CompetenceRun& run : runs) {
    if (const std::optional<bool> one = run.failed()) {
      failed.push_back(*one);
    }
  }
  return failed;
}

SessionOutcomes sessionsOf(std::span<const CompetenceRun> runs) {
  SessionOutcomes sessions;
  std::optional<std::int64_t> before_us;
  for (const CompetenceRun& run : runs) {
    const std::optional<bool> failed = run.failed();
    if (!failed) {
      continue;
    }
    if (!before_us || run.startedUtc_us - *before_us >= kSessionPause_us) {
      sessions.emplace_back();
    }
    sessions.back().push_back(*failed);
    before_us = run.startedUtc_us;
  }
  return sessions;
}

void setDependence(CompetenceDesign& design, const EstimatedDependence& estimated) {
  const CompetenceDesign assumed;
  const AttemptDependence dependence = estimated.dependence.value_or(
      AttemptDependence{assumed.sessionCorrelation, assumed.lagCorrelation,
                        std::max(assumed.runsPerSession, estimated.runsOfSession)});
  design.sessionCorrelation = dependence.session;
  design.lagCorrelation = dependence.lag;
  design.runsPerSession = std::min<std::int64_t>(dependence.perSession, kMaxCompetenceAttempts);
  design.dependenceRuns = estimated.dependence ? estimated.attempts : 0;
}

std::size_t fewestForAble(const CompetenceDesign& design) {
  const double success = std::log((1.0 - design.adequate) / (1.0 - design.inadequate));
  return static_cast<std::size_t>(std::ceil(design.limit / success - 1e-9));
}

CompetenceVerdict judgeAttempts(const CompetenceDesign& design, const std::vector<bool>& failed) {
  const LcCusumDesign cusum = cusumOf(design);
  CompetenceVerdict verdict;
  verdict.design = design;
  verdict.attempts = failed.size();
  verdict.failed = static_cast<std::size_t>(std::count(failed.begin(), failed.end(), true));
  bool relapsed = false;
  auto from = failed.begin();
  while (from != failed.end()) {
    const std::vector<bool> rest(from, failed.end());
    const LcCusum learning = lcCusum(rest, cusum);
    const std::size_t until = learning.competentAt.value_or(rest.size());
    verdict.sums.insert(verdict.sums.end(), learning.sums.begin(),
                        learning.sums.begin() + static_cast<std::ptrdiff_t>(until));
    if (!learning.competentAt) {
      verdict.level = relapsed ? SkillLevel::kRelapsed : SkillLevel::kLearning;
      break;
    }
    if (!verdict.ableAt) {
      verdict.ableAt = verdict.sums.size();
    }
    verdict.level = SkillLevel::kSteady;
    const std::vector<bool> after(from + static_cast<std::ptrdiff_t>(until), failed.end());
    const RelapseWatch watch = watchForRelapse(after, cusum);
    const std::size_t seen = watch.alarmAt.value_or(after.size());
    verdict.sums.insert(verdict.sums.end(), watch.sums.begin(),
                        watch.sums.begin() + static_cast<std::ptrdiff_t>(seen));
    relapsed = watch.alarmAt.has_value();
    if (relapsed) {
      verdict.level = SkillLevel::kRelapsed;
    } else if (seen > 0 && verdict.sums.back() >= kWatchShare * design.limit) {
      verdict.level = SkillLevel::kWatch;
    }
    from += static_cast<std::ptrdiff_t>(until + seen);
    if (!relapsed) {
      break;
    }
  }
  if (const std::size_t fewest = fewestForAble(design); failed.size() < fewest) {
    verdict.level = SkillLevel::kNotShown;
    verdict.attemptsUntilLevel = fewest - failed.size();
  }
  return verdict;
}

bool isExpired(const CompetenceDesign& design, std::int64_t lastRunUtc_us, std::int64_t now_us) {
  return design.validDays > 0 && now_us - lastRunUtc_us > design.validDays * kDay_us;
}

std::size_t firstValidAttempt(const CompetenceDesign& design, const std::vector<bool>& failed,
                              std::span<const std::int64_t> startedUtc_us) {
  TORSIO_EXPECTS(failed.size() == startedUtc_us.size());
  std::size_t first = 0;
  for (std::size_t i = 1; i < failed.size(); ++i) {
    if (isExpired(design, startedUtc_us[i - 1], startedUtc_us[i]) &&
        isAble(judgeAttempts(design, {failed.begin() + static_cast<std::ptrdiff_t>(first),
                                      failed.begin() + static_cast<std::ptrdiff_t>(i)})
                   .level)) {
      first = i;
    }
  }
  return first;
}

CompetenceVerdict judgeCompetence(const CompetenceDesign& design, const std::vector<bool>& failed) {
  CompetenceVerdict verdict = judgeAttempts(design, failed);
  verdict.errors = competenceErrors(design, std::ssize(failed));
  verdict.made = competenceOdds(design, std::ssize(failed));
  verdict.planned = competenceOdds(design, design.attempts);
  return verdict;
}

}  // namespace torsio
