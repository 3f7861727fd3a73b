// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/trial_summary.h"

#include <algorithm>
#include <cmath>

#include "sim/base/angle.h"

namespace torsio {

namespace {

/// A twist that turned less than this was a touch, not an attempt.
constexpr double kSmallestTwist_rad = radians(2.0);

}  // namespace

TrialDigest trialDigest(const Trial& trial, std::span<const Sample> samples, double tolerance_rad) {
  TrialDigest digest;
  digest.trialId = trial.header.trialId;
  digest.trainee = trial.header.traineeCode;
  digest.phase = trial.header.phaseLabel;
  digest.samples = trial.summary.samples;
  digest.minutes =
      static_cast<double>(trial.summary.samples) * static_cast<double>(trial.header.tickPeriod_us) / 60e6;
  digest.refusedSamples = trial.summary.refusedSamples;
  digest.lateTicks = trial.summary.lateTicks;
  digest.interrupted = trial.summary.outcome == TrialOutcome::kInterrupted;
  digest.contentHash = trial.summary.contentHash;

  double errorSum_rad = 0.0;
  double torque_Nm = 0.0;
  double force_N = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    torque_Nm = std::max(torque_Nm, std::abs(sample.response.torque_Nm));
    force_N = std::max(force_N, norm(sample.force_N));
    const bool letGo = sample.phase == ExercisePhase::kTwisting &&
                       (i + 1 == samples.size() || samples[i + 1].phase != ExercisePhase::kTwisting);
    if (!letGo || std::abs(sample.response.angle_rad) < kSmallestTwist_rad) continue;
    const double error_rad = std::abs(sample.response.angle_rad - trial.header.targetAngle_rad);
    ++digest.twists;
    if (error_rad <= tolerance_rad) ++digest.twistsOnTarget;
    errorSum_rad += error_rad;
    digest.attempts.push_back({degrees(error_rad), error_rad <= tolerance_rad});
  }
  if (digest.twists > 0) {
    digest.meanAbsoluteError_deg = degrees(errorSum_rad / static_cast<double>(digest.twists));
    digest.peakTorque_Nm = torque_Nm;
    digest.peakForce_N = force_N;
  }
  return digest;
}

}  // namespace torsio
