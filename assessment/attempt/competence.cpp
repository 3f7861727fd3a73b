// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/competence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/statistics/cusum.h"
#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr double kWatchShare = 0.5;

LcCusumDesign cusumOf(const CompetenceDesign& design) {
  return {.adequate = design.adequate, .inadequate = design.inadequate, .limit = design.limit};
}

void requireShare(double value, const Text& name) {
  if (!(value > 0.0 && value < 1.0)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("must lie above 0 and below 1"), name,
                Text::tr("Give a share such as 0.05"));
  }
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
                Text::tr("number of attempts"), Text::tr("Give as many as a trainee makes, such as 50"));
  }
  if (!(design.tolerance_rad > 0.0 && design.tolerance_rad <= std::numbers::pi)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("must lie above 0 and at most at 180 degrees"),
                Text::tr("tolerance"), Text::tr("Give an angle in degrees"));
  }
}

Text percent(double share) {
  const double tenths = std::round(1000.0 * share);
  return Text::verbatim("%1.%2 %", static_cast<std::int64_t>(tenths) / 10,
                        static_cast<std::int64_t>(tenths) % 10);
}

}  // namespace

CompetenceErrors competenceErrors(const CompetenceDesign& design, std::int64_t attempts) {
  TORSIO_EXPECTS(attempts >= 1);
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

CompetenceDesign plannedCompetence(CompetenceDesign design) {
  requireSoundNumbers(design);
  const auto n = static_cast<std::size_t>(design.attempts);
  const std::optional<double> limit =
      chooseLcCusumLimit(design.adequate, design.inadequate, n, design.falsePassMost);
  if (!limit) {
    throw Error(
        ErrorCode::kBadParameter, Text::tr("no limit keeps the largest false pass within these attempts"),
        Text::tr("competence design"), Text::tr("Plan more attempts, or rates that lie farther apart"));
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
        Text::tr(
            "%1 of the adequate trainees would not pass within %2 {attempt|attempts}; at most %3 are wanted",
            percent(errors.falseFail), design.attempts, percent(design.falseFailMost)),
        Text::tr("competence design"), Text::tr("Plan more attempts, or rates that lie farther apart"));
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

std::vector<bool> failedAttempts(const CompetenceDesign& design, std::span<const CompetenceRun> runs) {
  std::vector<bool> failed;
  for (const CompetenceRun& run : runs) {
    if (run.untwisting) {
      if (run.outcome != RunOutcome::kNotJudged) {
        failed.push_back(run.outcome != RunOutcome::kPassed);
      }
      continue;
    }
    for (const JudgedTwist& twist : run.twists) {
      // Judged by the same tolerance: use the exercise's own result.
      const bool within = run.tolerance_rad == design.tolerance_rad
                              ? twist.onTarget
                              : twist.error_deg <= degrees(design.tolerance_rad);
      failed.push_back(!within || !run.withinLimits);
    }
  }
  return failed;
}

std::size_t fewestForAble(const CompetenceDesign& design) {
  const double success = std::log((1.0 - design.adequate) / (1.0 - design.inadequate));
  return static_cast<std::size_t>(std::ceil(design.limit / success - 1e-9));
}

CompetenceVerdict judgeCompetence(const CompetenceDesign& design, const std::vector<bool>& failed) {
  const LcCusumDesign cusum = cusumOf(design);
  CompetenceVerdict verdict;
  verdict.design = design;
  verdict.attempts = failed.size();
  verdict.failed = static_cast<std::size_t>(std::count(failed.begin(), failed.end(), true));
  verdict.errors = competenceErrors(design, std::max<std::int64_t>(design.attempts, std::ssize(failed)));
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

}  // namespace torsio
