// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/study/curriculum.h"

namespace torsio {

/// Share of simulated trainees with one failure rate that the rule declares competent, beside the probability
/// that screens and report state for it.
struct SimulatedShare {
  double failureRate = 0.0;  ///< share of all runs that fail
  double declared = 0.0;
  double printed = 0.0;
};

/// One way in which runs fail.
struct CompetenceScenario {
  std::string name{};
  std::string description{};
  CompetenceDesign design{};  ///< planned with the dependence estimated from simulated trainees of this kind
  SimulatedShare inadequate{};
  SimulatedShare adequate{};
  /// The same before a centre has enough runs: by the design as given, with the dependence that it assumes.
  SimulatedShare assumedInadequate{};
  SimulatedShare assumedAdequate{};
};

inline constexpr std::int64_t kMaxSimulatedTrainees = 100'000;
/// Simulates the real rule (force, torque, angle, interruption, ending while holding) for each scenario with
/// `trainees` trainees of the design's inadequate failure rate and as many of the adequate one. As at a
/// centre, the dependence of runs is estimated from the runs of other trainees and the limit follows from it;
/// with `keepLimit` the design's own limit is used. The same numbers for the same seed. Throws like
/// plannedCompetence().
[[nodiscard]] std::vector<CompetenceScenario> simulateCompetence(const CompetenceDesign& design,
                                                                 std::int64_t trainees, std::uint64_t seed,
                                                                 bool keepLimit = false);

}  // namespace torsio
