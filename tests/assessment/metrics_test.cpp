// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/catalogue/quantity.h"
#include "assessment/metrics/loading.h"
#include "assessment/metrics/movement.h"
#include "assessment/metrics/signal.h"
#include "assessment/metrics/tracking.h"
#include "assessment/metrics/trial_metrics.h"
#include "sim/core/error.h"
#include "tests/assessment/reference_case.h"

namespace torsio {
namespace {

using test::matches;
using test::numbers;
using test::ReferenceCase;
using test::referenceCase;

constexpr double kRate = 1000.0;
constexpr double kPi_ = std::numbers::pi;

double minimumJerk(double s) {
  return s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
}
double minimumJerkSpeed(double s) {
  return 30.0 * s * s * (1.0 - s) * (1.0 - s);
}

/// Speed of a minimum-jerk turn of `angle` in `duration` seconds.
std::vector<double> turnSpeed(double angle, double duration) {
  std::vector<double> out;
  const int n = static_cast<int>(std::lround(duration * kRate));
  for (int i = 0; i <= n; ++i) {
    out.push_back(angle * minimumJerkSpeed(static_cast<double>(i) / n) / duration);
  }
  return out;
}

std::vector<double> twoSubMovements() {
  std::vector<double> out = turnSpeed(60.0, 1.5);
  const std::vector<double> second = turnSpeed(30.0, 1.5);
  for (std::size_t i = 1; i < second.size(); ++i) {
    out.push_back(second[i]);
  }
  return out;
}

class TraceCase : public ::testing::Test {
 protected:
  ReferenceCase reference = referenceCase("metrics", "trace_metrics");

  void expectValue(const char* group, const char* name, double got) const {
    EXPECT_TRUE(matches(got, reference.expected.at(group).at(name).get<double>(), reference.tolerance))
        << group << "." << name;
  }
};

TEST_F(TraceCase, SpectralArcLengthAgreesWithTheAuthorsExampleAndTheTurns) {
  std::vector<double> bell;
  for (int i = 0; i < 200; ++i) {
    bell.push_back(std::exp(-5.0 * std::pow(-1.0 + 0.01 * i, 2)));
  }
  expectValue("author_docstring", "sparc", *spectralArcLength(bell, 100.0));
  expectValue("minjerk", "sparc", *spectralArcLength(turnSpeed(90.0, 2.0), kRate));
  expectValue("minjerk", "sparc_T1_A1", *spectralArcLength(turnSpeed(1.0, 1.0), kRate));
  expectValue("minjerk", "sparc_T4_A30", *spectralArcLength(turnSpeed(30.0, 4.0), kRate));
  expectValue("minjerk", "sparc_fc20", *spectralArcLength(turnSpeed(90.0, 2.0), kRate, {.cutoff_Hz = 20.0}));
  expectValue("two_sub", "sparc", *spectralArcLength(twoSubMovements(), kRate));
  EXPECT_FALSE(spectralArcLength(std::vector<double>(100, 0.0), kRate));
}

TEST_F(TraceCase, SpectralArcLengthMatchesAPlainTransformForAnyLengthAndPadding) {
  for (const std::size_t n :
       {std::size_t{2}, std::size_t{3}, std::size_t{31}, std::size_t{64}, std::size_t{65}}) {
    std::vector<double> speed;
    for (std::size_t i = 0; i < n; ++i) {
      speed.push_back(1.0 + std::sin(0.7 * static_cast<double>(i)) + 0.3 * static_cast<double>(i % 3));
    }
    for (const int padding : {0, 1, 4}) {
      const std::size_t size = std::bit_ceil(n) << padding;
      std::vector<double> amplitude;
      for (std::size_t k = 0; k < size; ++k) {
        std::complex<double> sum;
        for (std::size_t i = 0; i < n; ++i) {
          sum += std::polar(speed[i], -2.0 * std::numbers::pi * static_cast<double>(k * i % size) /
                                          static_cast<double>(size));
        }
        amplitude.push_back(std::abs(sum));
      }
      const double largest = *std::max_element(amplitude.begin(), amplitude.end());
      const double step_Hz = 20.0 / static_cast<double>(size);
      const std::size_t last = std::min(size - 1, static_cast<std::size_t>(std::floor(10.0 / step_Hz)));
      double length = 0.0;
      for (std::size_t k = 1; k <= last; ++k) {
        length += std::hypot(1.0 / static_cast<double>(last), (amplitude[k] - amplitude[k - 1]) / largest);
      }
      const SparcOptions all{.paddingLevel = padding, .cutoff_Hz = 10.0, .amplitudeThreshold = 0.0};
      EXPECT_NEAR(*spectralArcLength(speed, 20.0, all), -length, 1e-12) << n << " padded " << padding;
    }
  }
}

TEST_F(TraceCase, LogDimensionlessJerkFollowsTheRecommendedRule) {
  expectValue("ldlj_full_trapezoid", "T2_A90", *logDimensionlessJerk(turnSpeed(90.0, 2.0), kRate));
  expectValue("ldlj_full_trapezoid", "T1_A1", *logDimensionlessJerk(turnSpeed(1.0, 1.0), kRate));
  expectValue("ldlj_full_trapezoid", "T4_A30", *logDimensionlessJerk(turnSpeed(30.0, 4.0), kRate));
  expectValue("ldlj_full_trapezoid", "two_sub", *logDimensionlessJerk(twoSubMovements(), kRate));
  // The analytic value of one minimum-jerk turn, which the rule approaches as the sample rate grows.
  EXPECT_NEAR(*logDimensionlessJerk(turnSpeed(90.0, 2.0), kRate),
              reference.expected.at("minjerk").at("ldlj_exact").get<double>(), 1e-5);
  EXPECT_FALSE(logDimensionlessJerk(std::vector<double>(100, 0.0), kRate));
}

TEST_F(TraceCase, PeaksIdleTimeAndPathsAgree) {
  EXPECT_EQ(speedPeaks(turnSpeed(90.0, 2.0), kRate).size(), 1U);
  EXPECT_EQ(speedPeaks(twoSubMovements(), kRate),
            reference.expected.at("two_sub").at("peak_idx").get<std::vector<std::size_t>>());
  // The case counts all samples below the threshold, including the short intervals at both ends.
  expectValue("two_sub", "idle_time_s_lt1", idleTime(twoSubMovements(), 1.0, kRate, 0.0));
  std::vector<Vec3> helix;
  for (int i = 0; i <= 4000; ++i) {
    const double phi = 4.0 * kPi_ * i / 4000.0;
    helix.push_back({20.0 * std::cos(phi), 20.0 * std::sin(phi), 5.0 * phi});
  }
  expectValue("helix", "polyline", pathLength(helix));
  expectValue("helix", "economy_chord_over_path",
              *economy(norm(helix.back() - helix.front()), pathLength(helix)));
  EXPECT_FALSE(economy(1.0, 0.0));
  EXPECT_NEAR(*axisWander(helix, {0, 0, 0}, {0, 0, 1}), 0.0, 1e-12);
}

TEST_F(TraceCase, StepResponseGivesOvershootAndSettling) {
  std::vector<double> angle;
  const double z = 0.5;
  const double wd = 6.0 * std::sqrt(0.75);
  for (int i = 0; i <= 3000; ++i) {
    const double t = i / kRate;
    angle.push_back(90.0 * (1.0 - std::exp(-3.0 * t) *
                                      (std::cos(wd * t) + z / std::sqrt(1.0 - z * z) * std::sin(wd * t))));
  }
  const TargetApproach got = targetApproach(angle, 90.0, 2.0, kRate);
  expectValue("step2", "overshoot_sampled", got.overshoot);
  expectValue("step2", "settle_2deg_sample", *got.settling);
  EXPECT_EQ(got.excursions, reference.expected.at("step2").at("n_overshoots_gt2").get<int>());
  // Entering 88..92 precedes the first sample at or above 90.
  EXPECT_LE(*got.timeToTarget, reference.expected.at("step2").at("first_sample_ge_90").get<double>());
  std::vector<double> mirrored;
  for (const double a : angle) {
    mirrored.push_back(-a);
  }
  EXPECT_EQ(targetApproach(mirrored, -90.0, 2.0, kRate).overshoot, got.overshoot);
  std::vector<double> turn;
  for (int i = 0; i <= 2000; ++i) {
    turn.push_back(90.0 * minimumJerk(i / 2000.0));
  }
  const TargetApproach smooth = targetApproach(turn, 90.0, 2.0, kRate);
  expectValue("minjerk", "t_settle_2deg_sample", *smooth.settling);
  EXPECT_EQ(smooth.excursions, 0);
  EXPECT_FALSE(targetApproach(std::vector<double>(10, 5.0), 90.0, 2.0, kRate).settling);
}

TEST_F(TraceCase, ForceMeasuresAgreeWithTheirIntegrals) {
  std::vector<double> force;
  for (int i = 0; i <= 2000; ++i) {
    force.push_back(3.0 * std::pow(std::sin(kPi_ * i / 2000.0), 2));
  }
  const Outcome<Loading> got = loadingOf(force, kRate);
  expectValue("force", "impulse_trapz", got->impulse);
  expectValue("force", "mean_exact", got->mean);
  expectValue("force", "peak", got->peak);
  expectValue("force", "p95_type7", got->p95);
  expectValue("force", "rms_exact", got->rms);
  EXPECT_NEAR(got->largestRate, reference.expected.at("force").at("peak_rate_exact").get<double>(), 1e-5);
  const Violations violations = violationsOf(force, 2.5, kRate);
  expectValue("force", "time_above_samples", violations.time_s);
  expectValue("force", "excess_impulse_trapz", violations.excessImpulse);
  EXPECT_EQ(violations.count, 1);
}

TEST(ViolationsOf, MergesNeighboursAndIgnoresTheShortest) {
  std::vector<double> force(1000, 0.0);
  for (std::size_t i = 100; i < 130; ++i) {
    force[i] = 5.0;  // 30 ms
  }
  for (std::size_t i = 160; i < 190; ++i) {
    force[i] = 5.0;  // 30 ms later: the same excursion
  }
  for (std::size_t i = 400; i < 405; ++i) {
    force[i] = 5.0;  // 5 ms: ignored
  }
  for (std::size_t i = 600; i < 620; ++i) {
    force[i] = 5.0;
  }
  const Violations got = violationsOf(force, 2.0, kRate);
  EXPECT_EQ(got.count, 2);
  EXPECT_DOUBLE_EQ(got.time_s, 0.085);
}

TEST_F(TraceCase, TrackingErrorSeparatesLagFromShape) {
  std::vector<double> target;
  std::vector<double> actual;
  for (int i = 0; i < 4000; ++i) {
    target.push_back(30.0 * std::sin(kPi_ * i / kRate));
    actual.push_back(30.0 * std::sin(kPi_ * (i / kRate - 0.05)));
  }
  const Outcome<TrackingError> got = trackingError(actual, target, kRate);
  expectValue("tracking", "rmse", got->rmse);
  expectValue("tracking", "mae", got->mae);
  expectValue("tracking", "max_abs", got->largest);
  EXPECT_NEAR(got->bias, 0.0, 1e-12);
  expectValue("tracking", "lag_s", *got->lag_s);
  EXPECT_NEAR(*got->rmseWithoutLag, 0.0, 1e-10);
  EXPECT_FALSE(trackingError(actual, std::vector<double>(4000, 1.0), kRate)->lag_s);
}

TEST(TrackingError, FindsTheLagOfALongSignalToOneSample) {
  std::vector<double> target;
  std::vector<double> actual;
  for (int i = 0; i < 60000; ++i) {
    target.push_back(std::sin(0.0007 * i) + 0.3 * std::sin(0.0031 * i));
    actual.push_back(std::sin(0.0007 * (i - 137)) + 0.3 * std::sin(0.0031 * (i - 137)));
  }
  EXPECT_DOUBLE_EQ(*trackingError(actual, target, kRate)->lag_s, 0.137);
}

/// Returns the gain of a single pass of a filter at a frequency.
double gainAt(const Biquad& f, double frequency_Hz, double rate_Hz) {
  const std::complex<double> z = std::polar(1.0, -2.0 * std::numbers::pi * frequency_Hz / rate_Hz);
  return std::abs((f.b0 + f.b1 * z + f.b2 * z * z) / (1.0 + f.a1 * z + f.a2 * z * z));
}

TEST_F(TraceCase, FiltersHaveTheStatedCoefficientsAndGain) {
  const nlohmann::json& butter = reference.expected.at("butter");
  for (const auto& [name, cutoff] :
       std::vector<std::pair<const char*, double>>{{"fc6", 6.0}, {"fc10", 10.0}, {"fc20", 20.0}}) {
    const auto expectFilter = [&](const Biquad& got, const char* b, const char* a) {
      EXPECT_TRUE(matches(got.b0, butter.at(name).at(b)[0].get<double>(), 1e-12));
      EXPECT_TRUE(matches(got.b1, butter.at(name).at(b)[1].get<double>(), 1e-12));
      EXPECT_TRUE(matches(got.b2, butter.at(name).at(b)[2].get<double>(), 1e-12));
      EXPECT_TRUE(matches(got.a1, butter.at(name).at(a)[1].get<double>(), 1e-12));
      EXPECT_TRUE(matches(got.a2, butter.at(name).at(a)[2].get<double>(), 1e-12));
    };
    expectFilter(butterworthForTwoPasses(cutoff, kRate), "dual_corrected_b", "dual_corrected_a");
    const double gain = gainAt(butterworthForTwoPasses(cutoff, kRate), cutoff, kRate);
    EXPECT_NEAR(gain * gain, butter.at(name).at("gain_sq_dual_at_fc").get<double>(), 1e-11);
  }
  const nlohmann::json& filtfilt = reference.expected.at("filtfilt");
  const std::vector<double> got =
      filterZeroPhase(butterworthForTwoPasses(10.0, kRate), numbers(filtfilt.at("x")), 9);
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_NEAR(got[i], filtfilt.at("y")[i].get<double>(), 1e-12) << i;
  }
}

TEST(Smoothness, DecreasesWithNoiseAsStatedForThePreparation) {
  const ReferenceCase c = referenceCase("metrics", "trace_noise_sensitivity");
  std::vector<double> clean;
  std::vector<double> noisy;
  for (int i = 0; i <= 2000; ++i) {
    clean.push_back(90.0 * minimumJerk(i / 2000.0));
    noisy.push_back(clean.back() + 0.05 * (((7 * i * i + 13 * i) % 101) - 50) / 50.0);
  }
  const auto expectBoth = [&](const char* name, const std::vector<double>& angle) {
    std::vector<double> speed = derivative(angle, kRate);
    EXPECT_TRUE(matches(*logDimensionlessJerk(speed, kRate), c.expected.at(name).at("ldlj").get<double>(),
                        c.tolerance))
        << name;
    for (double& value : speed) {
      value = std::abs(value);
    }
    EXPECT_TRUE(
        matches(*spectralArcLength(speed, kRate), c.expected.at(name).at("sparc").get<double>(), c.tolerance))
        << name;
  };
  expectBoth("clean", clean);
  expectBoth("unfiltered", noisy);
  expectBoth("fc6", lowPass(noisy, 6.0, kRate));
  expectBoth("fc10", lowPass(noisy, 10.0, kRate));
  expectBoth("fc20", lowPass(noisy, 20.0, kRate));
}

TEST(ResampleUniform, InterpolatesShortGapsAndRejectsLongOnes) {
  const UniformSignal got =
      resampleUniform(std::vector<std::int64_t>{0, 1000, 5000, 6000}, {{0.0, 1.0, 5.0, 6.0}});
  ASSERT_EQ(got.channels[0].size(), 7U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(got.channels[0][i], static_cast<double>(i), 1e-12);
  }
  EXPECT_EQ(got.lost, 3U);
  const std::vector<std::int64_t> broken = {0, 1000, 30000};
  EXPECT_THROW((void)resampleUniform(broken, {{0, 1, 2}}), Error);
  EXPECT_EQ(longGaps(broken), (std::vector<std::size_t>{1}));
  EXPECT_THROW((void)resampleUniform(std::vector<std::int64_t>{0, 0}, {{0, 1}}), Error);
}

TEST(TwistWork, ReturnsTheEnergyStoredByElasticTissue) {
  std::vector<double> torque;
  std::vector<double> angle;
  std::vector<double> lossy;
  for (int i = 0; i <= 2000; ++i) {
    angle.push_back(std::sin(kPi_ * i / 2000.0));
    torque.push_back(0.3 * angle.back());
    lossy.push_back(torque.back() + (i < 1000 ? 0.1 : -0.1));
  }
  const Outcome<TwistWork> elastic = twistWork(torque, angle);
  EXPECT_NEAR(elastic->delivered_J, 0.15, 1e-6);  // k theta^2 / 2
  EXPECT_NEAR(elastic->loop_J, 0.0, 1e-12);
  EXPECT_NEAR(twistWork(lossy, angle)->loop_J, 0.2, 1e-3);  // friction 0.1 N m over 1 rad, both ways
}

TrialTrace twistTrial() {
  TrialTrace trace;
  for (int i = 0; i <= 4000; ++i) {
    trace.times_us.push_back(1000 * i);
    const double s = std::clamp((i - 500) / 2000.0, 0.0, 1.0);
    const double fall = std::clamp((i - 3500) / 200.0, 0.0, 1.0);
    trace.phase.push_back(i < 500    ? TracePhase::kFree
                          : i < 2500 ? TracePhase::kTwisting
                          : i < 3500 ? TracePhase::kHolding
                                     : TracePhase::kReleasing);
    trace.angle_rad.push_back(0.5 * kPi_ * minimumJerk(s) * (1.0 - minimumJerk(fall)));
    trace.torque_Nm.push_back(0.2 * trace.angle_rad.back());
    trace.force_N.push_back(2.0 * s * (1.0 - fall));
    trace.tip_m.push_back(
        {0.02 * std::cos(trace.angle_rad.back()), 0.02 * std::sin(trace.angle_rad.back()), 0.0});
  }
  return trace;
}

TEST(MeasureTrial, AReversalHasAKinkOnlyInTheUnsignedSpeed) {
  TrialTrace trace = twistTrial();
  for (std::size_t i = 500; i < 2500; ++i) {
    trace.angle_rad[i] = 0.5 * std::sin(kPi_ * static_cast<double>(i - 500) / 2000.0);
  }
  const TrialMetrics got = measureTrial(trace, {});
  EXPECT_LT(*got.at(Quantity::kLdljUnsigned), *got.at(Quantity::kLdlj) - 0.1);
}

TEST(MeasureTrial, ReturnsEveryApplicableMetricAndLeavesTheOthersUndefined) {
  TrialTargets targets;
  targets.target_rad = 0.5 * kPi_;
  targets.forceLimit_N = 1.5;
  targets.axisPoint_m = Vec3{};
  const TrialMetrics got = measureTrial(twistTrial(), targets);
  EXPECT_EQ(got.all().size(), 36U);  // none of an untwisting
  // It never turns back, but for what the filter leaves of the end of the turn.
  EXPECT_NEAR(*got.at(Quantity::kLdlj), *got.at(Quantity::kLdljUnsigned), 0.1);
  EXPECT_DOUBLE_EQ(*got.at(Quantity::kTime), 4.0);
  EXPECT_NEAR(*got.at(Quantity::kEconomy), 1.0, 1e-3);
  // A turn of 2 s and a hold of 1 s in one window: longer than the turn alone, but as smooth.
  EXPECT_LT(*got.at(Quantity::kSparc), -1.3);
  EXPECT_GT(*got.at(Quantity::kSparc), -1.7);
  EXPECT_EQ(*got.at(Quantity::kSubMovements), 1.0);
  EXPECT_NEAR(*got.at(Quantity::kHoldSteadiness), 0.0, 2e-3);
  EXPECT_EQ(*got.at(Quantity::kForceViolations), 1.0);
  EXPECT_NEAR(*got.at(Quantity::kPeakForce), 2.0, 0.01);
  EXPECT_NEAR(*got.at(Quantity::kWorkDelivered), 0.1 * 0.25 * kPi_ * kPi_, 2e-3);
  EXPECT_NEAR(*got.at(Quantity::kAxisWander), 0.0, 1e-4);
  EXPECT_FALSE(got.at(Quantity::kTrackingRms));  // no course was shown
  EXPECT_FALSE(got.at(Quantity::kShearOverLimit));
  EXPECT_EQ(got.poseCutoff_Hz, kPoseCutoff_Hz);
}

TEST(MeasureTrial, AQuickReleaseChangesNeitherTheSteadinessOfTheHoldNorItsWork) {
  TrialTrace trace = twistTrial();
  for (std::size_t i = 0; i < trace.phase.size(); ++i) {
    if (trace.phase[i] == TracePhase::kHolding) {  // a tremor of 0.01 rad at 3 Hz, three periods
      trace.angle_rad[i] =
          0.5 * kPi_ + 0.01 * std::sin(6.0 * kPi_ * (static_cast<double>(i) - 2500.0) / kRate);
    } else if (trace.phase[i] == TracePhase::kReleasing) {
      trace.angle_rad[i] = 0.0;  // from one sample to the next
    }
    trace.torque_Nm[i] = 0.2 * trace.angle_rad[i];
  }
  TrialTargets targets;
  targets.target_rad = 0.5 * kPi_;

  const TrialMetrics got = measureTrial(trace, targets);

  EXPECT_NEAR(*got.at(Quantity::kHoldSteadiness), 0.01 / std::sqrt(2.0), 0.03 * 0.01);
  // 1/2 0.2 theta^2 up to the target; each of three tremors gives back what it takes: 0.2 theta 2 a.
  EXPECT_NEAR(*got.at(Quantity::kWorkLoop), 0.1 * 0.25 * kPi_ * kPi_, 1e-3);
}

/// A twist released during a gap of 15 samples, with timestamps that jitter by up to 0.3 ms: twisting until
/// 999 ms, releasing from 1015 ms on, no hold.
TrialTrace letGoInAGap() {
  TrialTrace trace;
  for (int i = 0; i < 1500; ++i) {
    if (i > 999 && i < 1015) {
      continue;
    }
    trace.times_us.push_back(1000 * i + 300 * ((i * 7) % 3 - 1));
    trace.phase.push_back(i < 1000 ? TracePhase::kTwisting : TracePhase::kReleasing);
    trace.angle_rad.push_back(i < 1000 ? 0.001 * i : std::exp(-0.01 * (i - 1000)));
  }
  return trace;
}

TEST(MeasureTrial, APhaseIsTakenFromTheSampleBeforeAndNeverInterpolated) {
  TrialTargets targets;
  targets.target_rad = 1.0;

  const TrialMetrics got = measureTrial(letGoInAGap(), targets);

  EXPECT_EQ(got.lostSamples,
            16U);  // of the grid: 1000 to 1015 ms after the first stamp, which is 0.3 ms early
  EXPECT_FALSE(got.at(Quantity::kHoldSteadiness)) << "between twisting and releasing lies no hold";
}

TEST(MeasureTrial, NoTwistingComesBetweenFreeAndHolding) {
  TrialTrace trace = letGoInAGap();
  for (std::size_t i = 0; i < trace.phase.size(); ++i) {
    trace.phase[i] = i < 1000 ? TracePhase::kFree : TracePhase::kHolding;
  }
  trace.force_N.assign(trace.phase.size(), 1.0);

  const TrialMetrics got = measureTrial(trace, {});

  // The organ is held from 1015.3 ms after the first stamp on: 484 points of the grid, 1016 to 1499.
  EXPECT_NEAR(*got.at(Quantity::kForceImpulse), 0.483, 1e-9);
}

TEST(SamplesInForce, AreTheLatestAtOrBeforeEachGridPoint) {
  // Grid at 0, 1, 2, 3, 4 ms; samples at 0, 0.7, 1.0, 3.4 and 4.0 ms.
  const std::vector<std::size_t> got = samplesInForce(std::vector<std::int64_t>{0, 700, 1000, 3400, 4000});

  EXPECT_EQ(got, (std::vector<std::size_t>{0, 2, 2, 2, 4}));
}

TEST(MeasureTrial, RejectsListsOfDifferentLengthAndInvalidValues) {
  TrialTrace trace = twistTrial();
  trace.force_N.pop_back();
  EXPECT_THROW((void)measureTrial(trace, {}), Error);
  trace = twistTrial();
  trace.angle_rad[7] = std::nan("");
  EXPECT_THROW((void)measureTrial(trace, {}), Error);
}

}  // namespace
}  // namespace torsio
