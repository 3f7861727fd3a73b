// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/kriging.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/core/random.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

constexpr Covariance kAll[] = {Covariance::kGaussian, Covariance::kExponential, Covariance::kSpherical,
                               Covariance::kMatern32, Covariance::kMatern52};

std::vector<double> evenSamples(int count) {
  std::vector<double> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    samples.push_back(static_cast<double>(i) / (count - 1));
  }
  return samples;
}

/// Returns the estimate of query number `query` of a table from `values`.
double estimateOf(const KrigingTable& table, int query, const std::vector<double>& values) {
  const std::span<const double> weights = table.row(query);
  const auto z = values.begin() + table.first()[static_cast<std::size_t>(query)];
  return std::inner_product(weights.begin(), weights.end(), z, 0.0);
}

std::vector<double> valuesOf(const std::function<double(double)>& field, const std::vector<double>& samples) {
  std::vector<double> values;
  values.reserve(samples.size());
  for (const double s : samples) {
    values.push_back(field(s));
  }
  return values;
}

/// Options with the range as a part of the whole length, and no window.
KrigingOptions global(Covariance covariance, double range, int count, Drift drift = Drift::kConstant) {
  return {.covariance = covariance, .rangeInSpacings = range * (count - 1), .drift = drift, .window = 0};
}

TEST(Covariance, FallsFromOneAtLagZero) {
  for (const Covariance c : kAll) {
    EXPECT_EQ(covarianceAt(c, 0.0, 0.7), 1.0);
    double before = 1.0;
    for (double lag = 0.05; lag < 3.0; lag += 0.05) {
      const double now = covarianceAt(c, lag, 0.7);
      EXPECT_LE(now, before);
      EXPECT_GE(now, 0.0);
      before = now;
    }
  }
  // Hand calculation at lag = range.
  EXPECT_NEAR(covarianceAt(Covariance::kGaussian, 2.0, 2.0), std::exp(-1.0), 1e-15);
  EXPECT_NEAR(covarianceAt(Covariance::kExponential, 2.0, 2.0), std::exp(-1.0), 1e-15);
  EXPECT_EQ(covarianceAt(Covariance::kSpherical, 2.0, 2.0), 0.0);
  EXPECT_NEAR(covarianceAt(Covariance::kSpherical, 1.0, 2.0), 0.3125, 1e-15);  // 1 - 3/4 + 1/16
  EXPECT_NEAR(covarianceAt(Covariance::kMatern32, 2.0, 2.0), 2.7320508075688772 * std::exp(-std::sqrt(3.0)),
              1e-15);
  EXPECT_NEAR(covarianceAt(Covariance::kMatern52, 2.0, 2.0), 4.9027346441664564 * std::exp(-std::sqrt(5.0)),
              1e-15);
}

struct Condition {
  Covariance covariance;
  int samples;
  double range;  // of the length
  double number;
};

class CovarianceCondition : public ::testing::TestWithParam<Condition> {};

TEST_P(CovarianceCondition, IsWhatTheRangeMakesIt) {
  const Condition c = GetParam();
  Eigen::MatrixXd matrix(c.samples, c.samples);
  for (int i = 0; i < c.samples; ++i) {
    for (int j = 0; j < c.samples; ++j) {
      matrix(i, j) = covarianceAt(c.covariance, std::abs(i - j) / (c.samples - 1.0), c.range);
    }
  }

  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix, Eigen::EigenvaluesOnly);
  const double number = eigen.eigenvalues()(c.samples - 1) / eigen.eigenvalues()(0);

  EXPECT_GT(number, c.number / 2.0);
  EXPECT_LT(number, c.number * 2.0);
}

// Condition numbers (2-norm) of the covariance matrix, measured once with another implementation.
INSTANTIATE_TEST_SUITE_P(Table, CovarianceCondition,
                         ::testing::Values(Condition{Covariance::kGaussian, 10, 0.1, 3.5},
                                           Condition{Covariance::kGaussian, 20, 0.1, 2e3},
                                           Condition{Covariance::kExponential, 20, 1.0, 551},
                                           Condition{Covariance::kExponential, 50, 0.3, 6e2},
                                           Condition{Covariance::kSpherical, 20, 3.0, 1e3},
                                           Condition{Covariance::kSpherical, 100, 0.3, 9e2},
                                           Condition{Covariance::kMatern32, 20, 0.3, 4e3},
                                           Condition{Covariance::kMatern32, 50, 1.0, 1e7},
                                           Condition{Covariance::kMatern52, 10, 0.3, 1e3},
                                           Condition{Covariance::kMatern52, 20, 1.0, 7e7},
                                           Condition{Covariance::kMatern52, 50, 0.3, 3e7}));

TEST(Kriging1d, KeepsTheConditionNumberBelowTenToTheTenWhateverTheNumberOfSamples) {
  constexpr double kLimit = 1e10;
  for (const int count : {2, 3, 5, 10, 20, 50, 100, 360}) {
    const Kriging1d local(evenSamples(count));
    const Kriging1d all(evenSamples(count), {.window = 0});

    EXPECT_LT(local.conditionNumber(), kLimit);
    EXPECT_LT(all.conditionNumber(), kLimit);
    EXPECT_EQ(local.nuggetUsed(), 0.0);
    EXPECT_EQ(all.nuggetUsed(), 0.0);
  }
}

TEST(Kriging1d, ReturnsSamplesAsTheyAre) {
  Random random(3);
  for (const Covariance c : kAll) {
    for (const Drift drift : {Drift::kConstant, Drift::kLinear}) {
      for (const int window : {0, 5, 8}) {
        const std::vector<double> samples = evenSamples(20);
        const std::vector<double> values = valuesOf([&](double) { return random.normal(); }, samples);
        const Kriging1d kriging(samples,
                                {.covariance = c, .rangeInSpacings = 4.0, .drift = drift, .window = window});

        for (std::size_t i = 0; i < samples.size(); ++i) {
          EXPECT_EQ(kriging.estimate(samples[i], values), values[i]);
          EXPECT_EQ(kriging.weights(samples[i]).variance, 0.0);
        }
      }
    }
  }
}

TEST(Kriging1d, ReachesTheSamplesContinuously) {
  constexpr double kExact = 1e-8;
  for (const int count : {10, 50, 360}) {
    for (const int window : {0, 8}) {
      const std::vector<double> samples = evenSamples(count);
      const std::vector<double> values =
          valuesOf([](double s) { return std::sinh(5.0 * s) / std::sinh(5.0); }, samples);
      const Kriging1d kriging(samples, {.window = window});

      for (std::size_t i = 0; i + 1 < samples.size(); i += 3) {
        EXPECT_NEAR(kriging.estimate(samples[i] + 1e-13, values), values[i], kExact);
        EXPECT_NEAR(kriging.estimate(samples[i + 1] - 1e-13, values), values[i + 1], kExact);
      }
    }
  }
}

TEST(Kriging1d, GivesWeightsThatSumToOne) {
  constexpr double kRounding = 1e-12;
  Random random(4);
  for (const Covariance c : kAll) {
    for (const Drift drift : {Drift::kConstant, Drift::kLinear}) {
      for (const int window : {0, 2, 3, 8}) {
        std::vector<double> samples = evenSamples(30);
        for (double& s : samples) {
          s += 0.3 / 30 * random.uniform();  // not equally spaced
        }
        const Kriging1d kriging(samples, {.covariance = c, .drift = drift, .window = window});

        for (int k = 0; k < 50; ++k) {
          const double query = samples.front() + (samples.back() - samples.front()) * random.uniform();
          const KrigingWeights w = kriging.weights(query);
          // The Gaussian's weights reach 1e4 with either sign; their sum is rounded at that size.
          double size = 0.0;
          for (const double lambda : w.lambda) {
            size += std::abs(lambda);
          }
          if (c != Covariance::kGaussian) {
            EXPECT_LT(size, 4.0);
          }
          EXPECT_NEAR(std::accumulate(w.lambda.begin(), w.lambda.end(), 0.0), 1.0,
                      kRounding * std::max(1.0, size));
          EXPECT_GE(w.variance, 0.0);
          EXPECT_EQ(static_cast<int>(w.lambda.size()), kriging.windowSize());
          double moment = 0.0;
          for (std::size_t i = 0; i < w.lambda.size(); ++i) {
            moment += w.lambda[i] * samples[static_cast<std::size_t>(w.first) + i];
          }
          if (drift == Drift::kLinear) {
            EXPECT_NEAR(moment, query, kRounding * std::max(1.0, size));
          }
        }
      }
    }
  }
}

TEST(Kriging1d, GivesTheSameWeightsFromTheVariogram) {
  // gamma = C(0) - C turns "C lambda - mu = c0" into "gamma lambda + mu = gamma0" with the same weights, and
  // Eq. 8 into sum lambda_i gamma_i0 + mu. Agreement falls with the condition number.
  constexpr double kEquivalence = 1e-9;
  const int count = 20;
  const std::vector<double> samples = evenSamples(count);
  for (const Covariance c :
       {Covariance::kExponential, Covariance::kSpherical, Covariance::kMatern32, Covariance::kMatern52}) {
    const double range = 0.5;
    const Kriging1d kriging(samples, global(c, range, count));
    Eigen::MatrixXd gamma = Eigen::MatrixXd::Ones(count + 1, count + 1);
    gamma(count, count) = 0.0;
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        gamma(i, j) = 1.0 - covarianceAt(c,
                                         std::abs(samples[static_cast<std::size_t>(i)] -
                                                  samples[static_cast<std::size_t>(j)]),
                                         range);
      }
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> solver(gamma);

    for (const double query : {0.013, 0.4, 0.777}) {
      Eigen::VectorXd right = Eigen::VectorXd::Ones(count + 1);
      for (int i = 0; i < count; ++i) {
        right(i) = 1.0 - covarianceAt(c, std::abs(samples[static_cast<std::size_t>(i)] - query), range);
      }
      const Eigen::VectorXd reference = solver.solve(right);
      const KrigingWeights w = kriging.weights(query);

      for (int i = 0; i < count; ++i) {
        EXPECT_NEAR(w.lambda[static_cast<std::size_t>(i)], reference(i), kEquivalence);
      }
      EXPECT_NEAR(w.variance, reference.head(count).dot(right.head(count)) + reference(count), kEquivalence);
    }
  }
}

TEST(Kriging1d, HasASmallerVarianceNearSamplesAndWithMoreOfThem) {
  const KrigingOptions options = global(Covariance::kMatern52, 0.5, 11);
  const Kriging1d few(evenSamples(11), options);
  KrigingOptions same = options;
  same.rangeInSpacings *= 2.0;  // the same range in length
  const Kriging1d many(evenSamples(21), same);

  EXPECT_LT(few.weights(0.501).variance, few.weights(0.55).variance);
  EXPECT_LT(many.weights(0.525).variance, few.weights(0.55).variance);
  EXPECT_LT(few.weights(0.55).variance, 1.0);
}

TEST(Kriging1d, IsExactForAUniformTwistWithTheLinearDrift) {
  constexpr double kRounding = 1e-12;
  for (const int count : {2, 3, 5, 20, 360}) {
    for (const int window : {0, 8}) {
      const std::vector<double> samples = evenSamples(count);
      const std::vector<double> values = valuesOf([](double s) { return 0.3 + 2.0 * s; }, samples);
      const Kriging1d kriging(samples, {.window = window});
      for (double s = 0.0; s <= 1.0; s += 0.0137) {
        EXPECT_NEAR(kriging.estimate(s, values), 0.3 + 2.0 * s, kRounding);
      }
    }
  }
}

TEST(Kriging1d, ErrsOnAUniformTwistWithTheConstantDriftOfThePaper) {
  // Matern 5/2, range 20 spacings, all samples: 8e-4 (M = 5), 1e-4 (10), 4e-5 (50) of the end angle.
  for (const auto& [count, error] : {std::pair{5, 8e-4}, std::pair{10, 1e-4}, std::pair{50, 4e-5}}) {
    const std::vector<double> samples = evenSamples(count);
    const Kriging1d kriging(samples, {.drift = Drift::kConstant, .window = 0});
    double worst = 0.0;
    for (int i = 0; i <= 1000; ++i) {
      worst = std::max(worst, std::abs(kriging.estimate(i / 1000.0, samples) - i / 1000.0));
    }

    EXPECT_LT(worst, 2.0 * error);
    EXPECT_GT(worst, error / 4.0);  // it does err
  }
}

/// Angle at s over the angle at the end for a bar whose radius is r(s): integral of r^-4.
std::function<double(double)> tapered(const std::function<double(double)>& radius) {
  return [radius](double s) {
    constexpr int kPairs = 60;  // Simpson: error below 1e-9
    double sum = 0.0;
    for (int i = 0; i <= 2 * kPairs; ++i) {
      const double weight = i == 0 || i == 2 * kPairs ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
      sum += weight * std::pow(radius(s * i / (2 * kPairs)), -4.0) * s / (6 * kPairs);
    }
    return sum;
  };
}

/// The five angle fields on which the methods are compared.
std::vector<std::function<double(double)>> angleFields() {
  return {[](double s) { return s; },                                            // prismatic
          [](double s) { return (std::pow(1.0 - 0.5 * s, -3.0) - 1.0) / 7.0; },  // radius falls to one half
          tapered([](double s) { return 45.0 - 17.0 * s + 6.0 * std::sin(kPi * s) * (1.0 - s); }),  // forearm
          tapered([](double s) {
            return 20.0 + 25.0 * std::pow(std::sin(kPi * (0.12 + 0.8 * s)), 1.5);
          }),                                                             // stomach
          [](double s) { return std::sinh(5.0 * s) / std::sinh(5.0); }};  // elastic foundation
}

struct Method {
  const char* name;
  Covariance covariance;
  double rangeInSpacings;
  double rangeInLengths;  // used when above 0
  Drift drift;
  int window;
  std::vector<std::pair<int, double>> largestError;  // samples, error / end angle: worst of the fields
};

class KrigingAccuracy : public ::testing::TestWithParam<Method> {};

TEST_P(KrigingAccuracy, IsWithinAFactorTwoOfTheMeasuredTable) {
  const Method& method = GetParam();
  const auto fields = angleFields();
  std::vector<double> queries;
  for (int i = 0; i <= 700; ++i) {
    queries.push_back(i / 700.0);
  }
  std::vector<std::vector<double>> exact;
  for (const auto& field : fields) {
    exact.push_back(valuesOf(field, queries));
    for (double& v : exact.back()) {
      v /= field(1.0);
    }
  }
  for (const auto& [count, error] : method.largestError) {
    KrigingOptions options{.covariance = method.covariance,
                           .rangeInSpacings = method.rangeInSpacings,
                           .drift = method.drift,
                           .window = method.window};
    if (method.rangeInLengths > 0.0) {
      options.rangeInSpacings = method.rangeInLengths * (count - 1);
    }
    const std::vector<double> samples = evenSamples(count);
    const KrigingTable table(Kriging1d(samples, options), queries);
    double worst = 0.0;
    for (std::size_t f = 0; f < fields.size(); ++f) {
      std::vector<double> values = valuesOf(fields[f], samples);
      for (double& v : values) {
        v /= fields[f](1.0);
      }
      for (std::size_t q = 0; q < queries.size(); ++q) {
        worst = std::max(worst, std::abs(estimateOf(table, static_cast<int>(q), values) - exact[f][q]));
      }
    }
    EXPECT_LT(worst, 2.0 * error) << method.name << ", M = " << count;
    EXPECT_GT(worst, error / 2.0) << method.name << ", M = " << count;
  }
}

// Largest error of the five fields, measured with another implementation.
INSTANTIATE_TEST_SUITE_P(
    Table, KrigingAccuracy,
    ::testing::Values(Method{"ordinary, exponential",
                             Covariance::kExponential,
                             20,
                             0,
                             Drift::kConstant,
                             0,
                             {{5, 1.1e-1}, {10, 4e-2}, {20, 1e-2}, {50, 1.6e-3}}},
                      Method{"ordinary, spherical",
                             Covariance::kSpherical,
                             0,
                             1.0,
                             Drift::kConstant,
                             0,
                             {{5, 1.2e-1}, {10, 4e-2}, {20, 1e-2}, {50, 1.7e-3}}},
                      Method{"ordinary, Matern 3/2",
                             Covariance::kMatern32,
                             20,
                             0,
                             Drift::kConstant,
                             0,
                             {{5, 9e-2}, {10, 2e-2}, {20, 6e-3}, {50, 1.5e-3}, {360, 4e-4}}},
                      Method{"ordinary, Matern 5/2",
                             Covariance::kMatern52,
                             20,
                             0,
                             Drift::kConstant,
                             0,
                             {{5, 6e-2}, {10, 1e-2}, {20, 1.7e-3}, {50, 2.5e-4}, {360, 4e-5}}},
                      Method{"linear drift, Matern 5/2",
                             Covariance::kMatern52,
                             20,
                             0,
                             Drift::kLinear,
                             0,
                             {{5, 6e-2}, {10, 9e-3}, {20, 1.4e-3}, {50, 1.8e-4}, {360, 2.3e-5}}},
                      Method{"the default: windows of 8",
                             Covariance::kMatern52,
                             20,
                             0,
                             Drift::kLinear,
                             8,
                             {{20, 1.4e-3}, {50, 1.6e-4}, {360, 2.6e-6}}}),
    [](const auto& method) {
      std::string name = method.param.name;
      std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
      return name;
    });

TEST(Kriging1d, RaisesTheNuggetOnlyWhenAPivotFails) {
  const std::vector<double> samples = evenSamples(50);
  const std::vector<double> values = valuesOf([](double s) { return std::sin(3.0 * s); }, samples);

  const Kriging1d gaussian(samples, global(Covariance::kGaussian, 0.3, 50));
  const Kriging1d matern(samples, global(Covariance::kMatern52, 0.3, 50));

  EXPECT_GT(gaussian.nuggetUsed(), 0.0);
  EXPECT_LE(gaussian.nuggetUsed(), 1.0001e-8);
  EXPECT_EQ(matern.nuggetUsed(), 0.0);
  for (double s = 0.003; s < 1.0; s += 0.017) {
    EXPECT_NEAR(gaussian.estimate(s, values), std::sin(3.0 * s), 1e-4);
  }
  EXPECT_EQ(gaussian.estimate(samples[7], values), values[7]);  // the copy, in spite of the nugget
  EXPECT_EQ(Kriging1d(samples, {.nugget = 1e-3}).nuggetUsed(), 1e-3);
}

TEST(Kriging1d, TreatsEqualSpacingLikeAnyOther) {
  // A shift of 1e-8 spacings takes the path with one system a window; the weights hardly change.
  const std::vector<double> even = evenSamples(25);
  std::vector<double> uneven = even;
  uneven[11] += 1e-8 / 24;
  const Kriging1d shared(even), separate(uneven);

  for (double s = 0.001; s < 1.0; s += 0.0071) {
    const KrigingWeights a = shared.weights(s), b = separate.weights(s);
    ASSERT_EQ(a.first, b.first);
    for (std::size_t i = 0; i < a.lambda.size(); ++i) {
      EXPECT_NEAR(a.lambda[i], b.lambda[i], 1e-6);
    }
  }
}

TEST(Kriging1d, UsesTheNearestSamplesOfAnUnevenRow) {
  const Kriging1d kriging(std::vector<double>{0.0, 0.1, 0.2, 1.0, 1.1, 1.2, 1.3}, {.window = 3});

  EXPECT_EQ(kriging.weights(0.05).first, 0);
  EXPECT_EQ(kriging.weights(0.5).first, 0);
  EXPECT_EQ(kriging.weights(0.9).first, 3);
  EXPECT_EQ(kriging.weights(1.29).first, 4);
}

TEST(Kriging1d, ClampsQueriesBeyondTheEnds) {
  const std::vector<double> samples = evenSamples(10);
  const std::vector<double> values = valuesOf([](double s) { return s * s; }, samples);
  const Kriging1d kriging(samples);

  EXPECT_EQ(kriging.estimate(-0.5, values), 0.0);
  EXPECT_EQ(kriging.estimate(7.0, values), 1.0);
}

TEST(Kriging1d, MirrorsItsWeightsWithItsSamples) {
  const Kriging1d kriging(evenSamples(24));
  for (const double s : {0.013, 0.21, 0.37, 0.499}) {
    const KrigingWeights left = kriging.weights(s), right = kriging.weights(1.0 - s);
    ASSERT_EQ(left.first, 24 - 8 - right.first);
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_NEAR(left.lambda[i], right.lambda[7 - i], 1e-8);
    }
  }
}

TEST(Kriging1d, RefusesBadSamplesAndOptions) {
  using ::testing::HasSubstr;
  const auto message = [](const std::vector<double>& samples,
                          const KrigingOptions& options = {}) -> std::string {
    const Error error = testing::refusal([&] { const Kriging1d kriging(samples, options); });
    EXPECT_EQ(error.code(), ErrorCode::kBadParameter);
    return error.happened() + " | " + error.where();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message({0.0}), HasSubstr("at least 2 samples, there are 1"));
  EXPECT_THAT(message({0.0, nan, 1.0}), HasSubstr("kriging sample 2"));
  EXPECT_THAT(message({0.0, 1.0, 1.0}), HasSubstr("must increase"));
  EXPECT_THAT(message({0.0, 1.0}, {.rangeInSpacings = 0.0}), HasSubstr("range is 0"));
  EXPECT_THAT(message({0.0, 1.0}, {.rangeInSpacings = nan}), HasSubstr("range"));
  EXPECT_THAT(message({0.0, 1.0}, {.nugget = -1.0}), HasSubstr("nugget is -1"));
  EXPECT_THAT(message({0.0, 1.0}, {.window = 1}), HasSubstr("window is 1"));
}

TEST(KrigingTable, HoldsTheSameWeightsAsSingleQueries) {
  Random random(8);
  const std::vector<double> samples = evenSamples(36);
  const std::vector<double> values = valuesOf([](double s) { return std::sinh(3.0 * s); }, samples);
  const Kriging1d kriging(samples);
  std::vector<double> queries = {samples[5], -1.0, 2.0};
  for (int i = 0; i < 200; ++i) {
    queries.push_back(random.uniform());
  }

  const KrigingTable table(kriging, queries);

  ASSERT_EQ(table.size(), static_cast<int>(queries.size()));
  ASSERT_EQ(table.width(), 8);
  ASSERT_EQ(table.lambda().size(), 8 * queries.size());
  for (int q = 0; q < table.size(); ++q) {
    const auto k = static_cast<std::size_t>(q);
    const KrigingWeights w = kriging.weights(queries[k]);
    EXPECT_EQ(table.first()[k], w.first);
    EXPECT_TRUE(std::equal(w.lambda.begin(), w.lambda.end(), table.row(q).begin()));
    EXPECT_EQ(estimateOf(table, q, values), kriging.estimate(queries[k], values));
  }
}

TEST(KrigedComponents, LeaveTheCircleAtLargeTwistAsThePaperWouldHaveIt) {
  // A point at radius 1 on the forearm field: rotating by the kriged angle keeps the radius; kriging the
  // components (Eq. 15) does not. Error / r at 180 degrees: angle 9e-4, components 0.11 (M = 10).
  const auto field = angleFields()[2];
  const int count = 10;
  const double twist = kPi, end = field(1.0);
  const std::vector<double> samples = evenSamples(count);
  std::vector<double> dx, dy, angle;
  for (const double s : samples) {
    angle.push_back(twist * field(s) / end);
    dx.push_back(std::cos(angle.back()) - 1.0);
    dy.push_back(std::sin(angle.back()));
  }
  const std::vector<double> dz(samples.size(), 0.25);
  const Kriging1d kriging(samples, {.window = 0});
  std::vector<double> queries;
  for (int i = 0; i <= 400; ++i) {
    queries.push_back(i / 400.0);
  }
  const KrigingTable table(kriging, queries);

  double worstComponents = 0.0, worstAngle = 0.0;
  for (int q = 0; q < table.size(); ++q) {
    const double query = queries[static_cast<std::size_t>(q)];
    const double exact = twist * field(query) / end;
    const double x = estimateOf(table, q, dx);
    const double y = estimateOf(table, q, dy);
    worstComponents = std::max(worstComponents, std::hypot(1.0 + x - std::cos(exact), y - std::sin(exact)));
    worstAngle = std::max(worstAngle, std::abs(estimateOf(table, q, angle) - exact));
    EXPECT_NEAR(estimateOf(table, q, dz), 0.25, 1e-12);  // a constant survives
    EXPECT_NEAR(kriging.estimate(query, dx), x, 1e-12);
    EXPECT_NEAR(kriging.estimate(query, dy), y, 1e-12);
  }

  EXPECT_LT(worstAngle, 5e-3);
  EXPECT_GT(worstComponents, 5.0 * worstAngle);
  EXPECT_LT(worstComponents, 0.25);
}

}  // namespace
}  // namespace torsio
