// SPDX-License-Identifier: GPL-3.0-or-later
// Two targets of the assessment: one million evaluations (Eqs. 25 to 27) of 40 raters x 9 indices within 2 s,
// and the metrics of a trial of 40 minutes (2.4 million samples) within 2 s.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "assessment/metrics/trial_metrics.h"
#include "assessment/scoring/evaluation_kernel.h"

namespace torsio {
namespace {

constexpr std::size_t kRaters = 40;
constexpr std::size_t kIndices = 9;
constexpr int kEvaluations = 1'000'000;

void evaluateAMillionTimes(benchmark::State& state) {
  std::vector<std::size_t> classes(kRaters, 0);  // 20 interns, 10 deputy chiefs, 10 chiefs, as in the paper
  for (std::size_t r = 20; r < kRaters; ++r) {
    classes[r] = r < 30 ? 1 : 2;
  }
  EvaluationKernel kernel(paperInstrument(), classes);
  std::vector<std::int64_t> steps(kRaters * kIndices);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i] = static_cast<std::int64_t>(i * 37 % 101);
  }
  std::vector<double> m(kIndices);
  std::vector<double> s2(kIndices);
  for (auto _ : state) {
    double sum = 0.0;
    for (int i = 0; i < kEvaluations; ++i) {
      steps[static_cast<std::size_t>(i) % steps.size()] = i % 101;  // never the same table twice in a row
      sum += kernel.run(steps, m, s2);
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * kEvaluations);
}
BENCHMARK(evaluateAMillionTimes)->Unit(benchmark::kMillisecond);

/// Returns successive twists of 20 s: 3 s free, 1 s contact, 12 s turning, 3 s hold, 1 s release.
TrialTrace longTrial(std::size_t samples) {
  constexpr std::size_t kPeriod = 20'000;
  constexpr double kTarget_rad = 1.2;
  TrialTrace trace;
  for (std::size_t i = 0; i < samples; ++i) {
    const std::size_t at = i % kPeriod;
    const double turn = at < 4000 ? 0.0 : at < 16'000 ? static_cast<double>(at - 4000) / 12'000.0 : 1.0;
    const double angle_rad =
        at >= 19'000 ? kTarget_rad * static_cast<double>(kPeriod - at) / 1000.0 : kTarget_rad * turn;
    trace.times_us.push_back(static_cast<std::int64_t>(i) * 1000);
    trace.phase.push_back(at < 3000     ? TracePhase::kFree
                          : at < 4000   ? TracePhase::kContact
                          : at < 16'000 ? TracePhase::kTwisting
                          : at < 19'000 ? TracePhase::kHolding
                                        : TracePhase::kReleasing);
    const double tremor = 0.001 * std::sin(0.05 * static_cast<double>(i));
    trace.angle_rad.push_back(angle_rad + tremor);
    trace.tip_m.push_back({0.03 * std::cos(angle_rad), 0.03 * std::sin(angle_rad), 0.1 + tremor});
    trace.force_N.push_back(std::abs(angle_rad) + 0.1 * std::abs(tremor));
    trace.torque_Nm.push_back(0.05 * angle_rad);
    trace.patchShear_Pa.push_back(1000.0 * angle_rad);
  }
  return trace;
}

void measureFortyMinutes(benchmark::State& state) {
  const TrialTrace trace = longTrial(2'400'000);
  TrialTargets targets;
  targets.target_rad = 1.2;
  targets.forceLimit_N = 1.0;
  targets.torqueLimit_Nm = 0.05;
  targets.shearLimit_Pa = 1000.0;
  targets.axisPoint_m = Vec3{0.0, 0.0, 0.1};
  for (auto _ : state) {
    benchmark::DoNotOptimize(measureTrial(trace, targets));
  }
  state.SetItemsProcessed(state.iterations() * 2'400'000);
}
BENCHMARK(measureFortyMinutes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace torsio

BENCHMARK_MAIN();
