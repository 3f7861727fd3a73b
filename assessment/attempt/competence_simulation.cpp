// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/competence_simulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "assessment/attempt/competence.h"
#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/core/random.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::int64_t kTwists = 10;    // of a whole run
constexpr std::int64_t kMaxMisses = 2;  // with which it passes: four in five must be on target
constexpr std::int64_t kRunsPerDay = 5;
constexpr std::int64_t kBetweenRuns_us = std::int64_t{600} * 1'000'000;
constexpr std::int64_t kCentre = 2'000;  // trainees from whom the dependence is estimated

/// The exercise that is simulated.
AttemptRules simulatedExercise(double tolerance_rad) {
  return {.tolerance_rad = tolerance_rad, .forceLimit_N = 3.3, .torqueLimit_Nm = 0.1, .leastTwists = 5};
}

/// One run as recorded.
struct SimulatedRun {
  std::int64_t onTarget = kTwists;
  std::int64_t missed = 0;
  std::int64_t cutOff = 0;
  double force_N = 2.0;
  bool interrupted = false;
  friend auto operator<=>(const SimulatedRun&,
                          const SimulatedRun&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Judges a run by the rule that judges recordings.
RunOutcome outcomeOf(const SimulatedRun& run, const CompetenceDesign& design, const AttemptRules& exercise) {
  AttemptMeasures measures;
  const double tolerance_deg = degrees(exercise.tolerance_rad);
  measures.twists.assign(static_cast<std::size_t>(run.onTarget), {0.5 * tolerance_deg, true});
  measures.twists.insert(measures.twists.end(), static_cast<std::size_t>(run.missed),
                         {2.0 * tolerance_deg, false});
  measures.unfinished = run.cutOff;
  measures.values = {{Quantity::kCompletedTwists, static_cast<double>(run.onTarget + run.missed)},
                     {Quantity::kTargetsReached, static_cast<double>(run.onTarget)},
                     {Quantity::kPeakForce, run.force_N},
                     {Quantity::kPeakTorque, 0.05},
                     {Quantity::kTornTwists, 0.0}};
  return run.interrupted ? RunOutcome::kInterrupted
                         : competenceOutcome(design, exercise, measures, exercise.tolerance_rad);
}

/// Judges each kind of run once.
class Judge {
 public:
  Judge(const CompetenceDesign& design, const AttemptRules& exercise)
      : design_(design), exercise_(exercise) {}

  RunOutcome operator()(const SimulatedRun& run) {
    const auto known = known_.find(run);
    return known != known_.end() ? known->second
                                 : known_.emplace(run, outcomeOf(run, design_, exercise_)).first->second;
  }

 private:
  const CompetenceDesign& design_;
  const AttemptRules& exercise_;
  std::map<SimulatedRun, RunOutcome> known_;
};

/// Probability of more than `most` misses among `twists` twists that each miss with probability `rate`.
double moreMisses(double rate, std::int64_t twists, std::int64_t most) {
  double term = std::pow(1.0 - rate, static_cast<double>(twists));
  double fewer = 0.0;
  for (std::int64_t misses = 0; misses <= most; ++misses) {
    fewer += term;
    term *= static_cast<double>(twists - misses) / static_cast<double>(misses + 1) * rate / (1.0 - rate);
  }
  return 1.0 - fewer;
}

/// Solves a rising function of one number.
double solved(const std::function<double(double)>& rising, double wanted, double low, double high) {
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (rising(middle) < wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Rate of misses at which a share of `failing` runs has more than `most` among `twists`.
double missRate(double failing, std::int64_t twists, std::int64_t most) {
  return solved([&](double rate) { return moreMisses(rate, twists, most); }, failing, 0.0, 1.0 - 1e-12);
}

double logistic(double x) {
  return 1.0 / (1.0 + std::exp(-x));
}

/// Mean of a function of a standard normal number.
double overNormal(const std::function<double(double)>& f) {
  constexpr double kEdge = 8.0;
  constexpr double kStep = 0.02;
  double sum = 0.0;
  double weights = 0.0;
  for (double z = -kEdge; z <= kEdge; z += kStep) {
    const double weight = std::exp(-0.5 * z * z);
    sum += weight * f(z);
    weights += weight;
  }
  return sum / weights;
}

std::int64_t missesIn(Random& random, double rate) {
  std::int64_t misses = 0;
  for (std::int64_t twist = 0; twist < kTwists; ++twist) {
    misses += random.uniform() < rate ? 1 : 0;
  }
  return misses;
}

/// A trainee's runs, one after the other.
using Hand = std::function<SimulatedRun(Random& random, std::int64_t number)>;

SimulatedRun withMisses(std::int64_t misses) {
  return {.onTarget = kTwists - misses, .missed = misses};
}

Hand independentHand(double failing) {
  return [rate = missRate(failing, kTwists, kMaxMisses)](Random& random, std::int64_t) {
    return withMisses(missesIn(random, rate));
  };
}

Hand roughHand(double failing) {
  return [failing](Random& random, std::int64_t) {
    return SimulatedRun{.force_N = random.uniform() < failing ? 4.0 : 2.0};
  };
}

Hand changingHand(double failing) {
  const double centre = solved(
      [](double x) {
        return overNormal([x](double z) { return moreMisses(logistic(x + z), kTwists, kMaxMisses); });
      },
      failing, -12.0, 8.0);
  return [centre, rate = 0.0](Random& random, std::int64_t number) mutable {
    if (number % kRunsPerDay == 0) {
      rate = logistic(centre + random.normal());
    }
    return withMisses(missesIn(random, rate));
  };
}

Hand repeatingHand(double failing, double lag) {
  return [failing, lag, failed = false](Random& random, std::int64_t number) mutable {
    if (number == 0 || random.uniform() >= lag) {
      failed = random.uniform() < failing;
    }
    return withMisses(failed ? kMaxMisses + 1 : 0);
  };
}

/// Ends the run at the second miss, by pulling the device's plug or while holding the organ.
Hand leavingHand(double failing, bool pullsThePlug) {
  // Of ten twists the last may be cut off while it is held: eight of ten are on target.
  const std::int64_t risky = pullsThePlug ? kTwists : kTwists - 1;
  return [pullsThePlug, rate = missRate(failing, risky, 1)](Random& random, std::int64_t) {
    SimulatedRun run{.onTarget = 0};
    for (std::int64_t twist = 0; twist < kTwists; ++twist) {
      if (random.uniform() >= rate) {
        ++run.onTarget;
      } else if (run.missed == 0) {
        ++run.missed;
      } else {
        run.interrupted = pullsThePlug;
        run.cutOff = 1;
        break;
      }
    }
    return run;
  };
}

struct Scenario {
  const char* name;
  const char* description;
  Hand (*hand)(double failing);
};

constexpr std::array kScenarios{
    Scenario{"independent", "each twist misses by itself", [](double f) { return independentHand(f); }},
    Scenario{"force_limit", "whole runs exceed the force limit, all angles are perfect",
             [](double f) { return roughHand(f); }},
    Scenario{"session_effect", "twists miss more often on some days: SD 1 logit, five runs a day",
             [](double f) { return changingHand(f); }},
    Scenario{"lag_0.2", "successive runs correlate at 0.2", [](double f) { return repeatingHand(f, 0.2); }},
    Scenario{"lag_0.4", "successive runs correlate at 0.4", [](double f) { return repeatingHand(f, 0.4); }},
    Scenario{"cut_at_second_miss", "the device is cut at the second miss",
             [](double f) { return leavingHand(f, true); }},
    Scenario{"ended_while_holding", "the run is ended at the second miss while the organ is held",
             [](double f) { return leavingHand(f, false); }},
};

std::vector<CompetenceRun> runsOf(std::int64_t count, Judge& judge, Hand hand, Random& random) {
  std::vector<CompetenceRun> runs;
  for (std::int64_t number = 0; number < count; ++number) {
    runs.push_back(
        {.outcome = judge(hand(random, number)),
         .startedUtc_us = number / kRunsPerDay * kDay_us + number % kRunsPerDay * kBetweenRuns_us});
  }
  return runs;
}

/// Simulates a centre whose trainees have the stated failure rates.
std::vector<SessionOutcomes> simulatedCentre(const Scenario& scenario, const CompetenceDesign& design,
                                             const AttemptRules& exercise, std::int64_t people,
                                             Random& random) {
  std::vector<SessionOutcomes> centre;
  Judge judge(design, exercise);
  for (const double rate : kStatedFailureRates) {
    const Hand hand = scenario.hand(rate);
    for (std::int64_t person = 0; person < people; person += std::ssize(kStatedFailureRates)) {
      centre.push_back(sessionsOf(runsOf(design.attempts, judge, hand, random)));
    }
  }
  return centre;
}

SimulatedShare simulatedShare(const Scenario& scenario, const CompetenceDesign& design,
                              const AttemptRules& exercise, double failureRate, std::int64_t trainees,
                              Random& random) {
  const Hand hand = scenario.hand(failureRate);
  Judge judge(design, exercise);
  std::int64_t declared = 0;
  for (std::int64_t trainee = 0; trainee < trainees; ++trainee) {
    const std::vector<CompetenceRun> runs = runsOf(design.attempts, judge, hand, random);
    declared += judgeAttempts(design, failedAttempts(runs)).ableAt ? 1 : 0;
  }
  return {.failureRate = failureRate,
          .declared = static_cast<double>(declared) / static_cast<double>(trainees),
          .printed = competenceProbability(design, failureRate, design.attempts)};
}

}  // namespace

std::vector<CompetenceScenario> simulateCompetence(const CompetenceDesign& design, std::int64_t trainees,
                                                   std::uint64_t seed, bool keepLimit) {
  TORSIO_EXPECTS(trainees >= 1 && trainees <= kMaxSimulatedTrainees);
  const AttemptRules exercise = simulatedExercise(design.tolerance_rad);
  std::vector<CompetenceScenario> all;
  for (std::size_t i = 0; i < kScenarios.size(); ++i) {
    const Scenario& scenario = kScenarios[i];
    Random random = Random::forStream(seed, i);
    CompetenceScenario out{.name = scenario.name, .description = scenario.description, .design = design};
    setDependence(out.design,
                  estimateDependence(simulatedCentre(scenario, design, exercise, kCentre, random)));
    if (!keepLimit) {
      out.design = plannedCompetence(out.design);
    }
    out.inadequate = simulatedShare(scenario, out.design, exercise, design.inadequate, trainees, random);
    out.adequate = simulatedShare(scenario, out.design, exercise, design.adequate, trainees, random);
    out.assumedInadequate = simulatedShare(scenario, design, exercise, design.inadequate, trainees, random);
    out.assumedAdequate = simulatedShare(scenario, design, exercise, design.adequate, trainees, random);
    all.push_back(std::move(out));
  }
  return all;
}

}  // namespace torsio
