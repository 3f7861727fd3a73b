// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/statistics/curve_fit.h"
#include "assessment/statistics/cusum.h"
#include "assessment/statistics/run_dependence.h"
#include "assessment/statistics/standard_setting.h"
#include "sim/core/random.h"
#include "tests/assessment/reference_case.h"

namespace torsio {
namespace {

using test::matches;
using test::numbers;
using test::ReferenceCase;
using test::referenceCase;

void expectFit(const CurveFit& got, const nlohmann::json& e, const char* coefficients, double tolerance) {
  for (std::size_t i = 0; i < got.parameters.size(); ++i) {
    EXPECT_TRUE(matches(got.parameters[i], e.at(coefficients)[i].get<double>(), tolerance)) << i;
    EXPECT_TRUE(matches(got.errors[i], e.at("se")[i].get<double>(), tolerance)) << i;
  }
  EXPECT_TRUE(matches(got.rss, e.at("rss").get<double>(), tolerance));
}

TEST(FitCurve, ReachesTheCertifiedValuesOfMisra1aFromBothStarts) {
  const ReferenceCase c = referenceCase("learning", "nist_misra1a");
  const Curve curve = [](std::span<const double> b, double x, std::span<double> d) {
    const double e = std::exp(-b[1] * x);
    d[0] = 1.0 - e;
    d[1] = b[0] * x * e;
    return b[0] * (1.0 - e);
  };
  for (const char* start : {"start1", "start2"}) {
    const Outcome<CurveFit> got =
        fitCurve(curve, numbers(c.input.at("x")), numbers(c.input.at("y")), numbers(c.input.at(start)));
    ASSERT_TRUE(got) << got.reason().str();
    expectFit(*got, c.expected, "b", c.tolerance);
    EXPECT_TRUE(matches(got->sigma, c.expected.at("sd").get<double>(), c.tolerance));
  }
}

TEST(FitCurve, ReachesTheCertifiedValuesOfDanWoodFromBothStarts) {
  const ReferenceCase c = referenceCase("learning", "nist_danwood");
  const Curve curve = [](std::span<const double> b, double x, std::span<double> d) {
    d[0] = std::pow(x, b[1]);
    d[1] = b[0] * d[0] * std::log(x);
    return b[0] * d[0];
  };
  for (const char* start : {"start1", "start2"}) {
    const Outcome<CurveFit> got =
        fitCurve(curve, numbers(c.input.at("x")), numbers(c.input.at("y")), numbers(c.input.at(start)));
    ASSERT_TRUE(got) << got.reason().str();
    expectFit(*got, c.expected, "b", c.tolerance);
  }
}

TEST(FitLearningCurve, AgreesForBothFamiliesOnBothDataSets) {
  const ReferenceCase c = referenceCase("learning", "learning_curves_rule");
  const std::vector<double> t = numbers(c.input.at("t"));
  for (const auto& [name, family, data] : std::vector<std::tuple<const char*, LearningFamily, const char*>>{
           {"exp_on_exp", LearningFamily::kExponential, "y_exp"},
           {"pow_on_exp", LearningFamily::kPower, "y_exp"},
           {"pow_on_pow", LearningFamily::kPower, "y_pow"},
           {"exp_on_pow", LearningFamily::kExponential, "y_pow"}}) {
    const Outcome<LearningCurve> got = fitLearningCurve(family, t, numbers(c.input.at(data)), false);
    ASSERT_TRUE(got) << name << got.reason().str();
    expectFit(got->fit, c.expected.at(name), "coef", c.tolerance);
    EXPECT_TRUE(matches(got->fit.sigma, c.expected.at(name).at("sigma").get<double>(), c.tolerance));
    EXPECT_TRUE(matches(got->fit.aicc, c.expected.at(name).at("AICc_rss_form").get<double>(), c.tolerance))
        << name;
    const Interval band = learningBandAt(*got, 5.0);
    EXPECT_LT(band.lower, learningCurveAt(*got, 5.0));
    EXPECT_GT(band.upper, learningCurveAt(*got, 5.0));
  }
  const Outcome<LogLogLine> line = logLogLine(t, numbers(c.input.at("y_pow")));
  const nlohmann::json& e = c.expected.at("loglog");
  EXPECT_TRUE(matches(line->slope, e.at("slope").get<double>(), 1e-9));
  EXPECT_TRUE(matches(line->intercept, e.at("intercept").get<double>(), 1e-9));
  EXPECT_TRUE(matches(line->ratePerDoubling, e.at("learning_rate_per_doubling").get<double>(), 1e-9));
  EXPECT_TRUE(matches(line->rSquared, e.at("r2").get<double>(), 1e-9));
}

Outcome<LearningCurve> exponentialOf(const std::vector<double>& error) {
  std::vector<double> attempt(error.size());
  std::iota(attempt.begin(), attempt.end(), 1.0);
  return fitLearningCurve(LearningFamily::kExponential, attempt, error);
}

TEST(FitLearningCurve, FindsTheRateToTheLastDigits) {
  // Near the minimum the squares of these errors no longer change; their derivative does. With 60 digits:
  const Outcome<LearningCurve> got = exponentialOf(
      {4.038089015174049,  5.148028585479431,   3.983205387978457, 5.670835384802446, 7.681882868243928,
       5.90456219529016,   1.3386557963146795,  5.830839578670681, 2.50324408111964,  1.9078664474653482,
       4.7762649201087894, 0.33846042496866513, 4.31344680193596,  2.305149653031106, 1.6937807673147143,
       0.3099557746609044, 1.0990563055468712,  1.381856676947542, 2.755374021746963, 6.1299693843525835});
  ASSERT_TRUE(got) << got.reason().str();
  EXPECT_NEAR(got->asymptote, 1.27562847924453624855, 1e-12);
}

TEST(FitLearningCurve, IsUndefinedIfTheFirstAttemptStandsApart) {
  // Ever faster rates fit ever better: a valley on the way is not the best fit.
  EXPECT_THAT(exponentialOf({1.2206322200956747, 3.4644494002670156, 3.0242573854239074, 2.9076948515824865,
                             0.8909750859692185, 0.7879916518724008, 1.246856498378819, 1.103382136900103,
                             5.325634042814083, 0.6655563006308953})
                  .reason()
                  .str(),
              ::testing::HasSubstr("the first attempt differs too much"));
}

TEST(FitLearningCurve, HoldsAnAbsurdAsymptoteAtZeroAndRefusesThreeAttempts) {
  const ReferenceCase c = referenceCase("learning", "learning_curves_rule");
  const Outcome<LearningCurve> held =
      fitLearningCurve(LearningFamily::kPower, numbers(c.input.at("t")), numbers(c.input.at("y_exp")));
  EXPECT_TRUE(held->asymptoteAtZero);
  EXPECT_EQ(held->asymptote, 0.0);
  const std::vector<double> three = {1, 2, 3};
  EXPECT_THAT(fitLearningCurve(LearningFamily::kPower, three, three).reason().str(),
              ::testing::HasSubstr("eight"));
}

TEST(TabularCusum, AgreesWithMontgomerysTable) {
  const ReferenceCase c = referenceCase("learning", "cusum_tabular_montgomery");
  const TabularCusum got = tabularCusum(numbers(c.input.at("x")), 10.0, 0.5, 5.0);
  const nlohmann::json& rows = c.expected.at("rows_i_x_Cplus_Nplus_Cminus_Nminus");
  for (std::size_t i = 0; i < got.points.size(); ++i) {
    // The printed rows are exact decimals; sums of doubles differ in the last bits.
    EXPECT_NEAR(got.points[i].upper, rows[i][2].get<double>(), 1e-12);
    EXPECT_NEAR(got.points[i].lower, rows[i][4].get<double>(), 1e-12);
    EXPECT_EQ(got.points[i].upperRun, rows[i][3].get<int>());
    EXPECT_EQ(got.points[i].lowerRun, rows[i][5].get<int>());
  }
  EXPECT_EQ(got.firstSignal, c.expected.at("first_signal").get<std::size_t>());
}

TEST(AverageRunLength, AgreesInAndOutOfControl) {
  const ReferenceCase c = referenceCase("learning", "cusum_arl");
  for (const auto& [name, h, shift] :
       std::vector<std::tuple<const char*, double, double>>{{"k0.5_h4_shift0", 4, 0},
                                                            {"k0.5_h4_shift1", 4, 1},
                                                            {"k0.5_h5_shift0", 5, 0},
                                                            {"k0.5_h5_shift1", 5, 1}}) {
    const nlohmann::json& e = c.expected.at(name);
    EXPECT_TRUE(matches(averageRunLengthTwoSided(0.5, h, shift).value(), e.at("two_sided").get<double>(),
                        c.tolerance))
        << name;
  }
  EXPECT_TRUE(matches(averageRunLengthOneSided(0.5, 4, 0).value(),
                      c.expected.at("one_sided_h4").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(averageRunLengthOneSided(0.5, 5, 0).value(),
                      c.expected.at("one_sided_h5").get<double>(), c.tolerance));
}

TEST(AverageRunLength, GrowsWithTheLimitUpToDoublePrecision) {
  for (const double h : {8.0, 14.0, 20.0}) {
    const double away = h + 1.166;  // Siegmund (1985): (exp(2 k b) - 1 - 2 k b) / (2 k^2) for k = 1/2
    const double siegmund = 2.0 * (std::exp(away) - 1.0 - away);
    EXPECT_NEAR(averageRunLengthOneSided(0.5, h, 0.0).value(), siegmund, 0.01 * siegmund) << h;
  }
  EXPECT_FALSE(averageRunLengthOneSided(0.5, 40.0, 0.0));
  EXPECT_FALSE(averageRunLengthTwoSided(0.5, 100.0, 0.0));
  EXPECT_NEAR(averageRunLengthOneSided(0.5, 100.0, 1.5).value(), 100.0, 3.0);  // drifts by 1 per value
}

std::vector<bool> outcomes(const nlohmann::json& list) {
  std::vector<bool> out;
  for (const nlohmann::json& value : list) {
    out.push_back(value.get<int>() == 1);
  }
  return out;
}

TEST(BinaryCusum, AgreesWithTheSeries) {
  const ReferenceCase c = referenceCase("learning", "cusum_binary_and_lc");
  const nlohmann::json& e = c.expected.at("cusum_sprt");
  const BinaryCusum got = binaryCusum(outcomes(c.input.at("outcomes_failure1")), 0.1, 0.2, 0.1, 0.1);
  EXPECT_TRUE(matches(got.s, e.at("s").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got.h0, e.at("h0").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got.h1, e.at("h1").get<double>(), c.tolerance));
  for (std::size_t i = 0; i < got.sums.size(); ++i) {
    EXPECT_TRUE(matches(got.sums[i], e.at("S")[i].get<double>(), c.tolerance)) << i;
  }
}

TEST(LcCusum, SignalsWhereTheSeriesDoes) {
  const ReferenceCase c = referenceCase("learning", "cusum_binary_and_lc");
  const nlohmann::json& e = c.expected.at("lc_cusum");
  const LcCusum got = lcCusum(outcomes(c.input.at("outcomes_failure1")), {0.1, 0.2, 1.25});
  EXPECT_TRUE(matches(got.successWeight, e.at("w_success").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got.failureWeight, e.at("w_failure").get<double>(), c.tolerance));
  for (std::size_t i = 0; i < got.sums.size(); ++i) {
    EXPECT_NEAR(got.sums[i], e.at("S")[i].get<double>(), 1e-12) << i;
  }
  EXPECT_EQ(got.competentAt, 32U);  // stated with the series: signals at trial 32 with h = 1.25
}

TEST(LcCusumProbability, OfManyAttemptsIsThatOfARenewalProcess) {
  const LcCusumDesign design{0.1, 0.2, 3.0};

  const double some = 1.0 - lcCusumProbability(design, 0.2, 1000);
  const double more = 1.0 - lcCusumProbability(design, 0.2, 1500);
  const double most = 1.0 - lcCusumProbability(design, 0.2, 2000);

  EXPECT_GT(some, more);
  EXPECT_NEAR(most / more, more / some, 1e-9);  // by then the start no longer matters
  const double endless = 1.0 - lcCusumProbability({0.1, 0.2, 6.0}, 0.2, 20'000);
  EXPECT_NEAR(endless, std::pow(1.0 - lcCusumProbability({0.1, 0.2, 6.0}, 0.2, 10'000), 2), 0.01 * endless);
}

TEST(LcCusumProbability, AgreesWithTheExactTable) {
  const ReferenceCase c = referenceCase("learning", "cusum_binary_and_lc");
  const nlohmann::json* table = nullptr;
  for (const auto& [key, value] : c.expected.items()) {
    if (value.is_object() && value.contains("1.25")) {
      table = &value;
    }
  }
  if (table == nullptr) {
    for (const auto& [key, value] : c.expected.at("lc_cusum").items()) {
      if (value.is_object() && value.contains("1.25")) {
        table = &c.expected.at("lc_cusum").at(key);
      }
    }
  }
  ASSERT_NE(table, nullptr);
  int compared = 0;
  for (const auto& [h, byAttempts] : table->items()) {
    for (const auto& [attempts, byRate] : byAttempts.items()) {
      for (const auto& [rate, probability] : byRate.items()) {
        const double got =
            lcCusumProbability({0.1, 0.2, std::stod(h)}, std::stod(rate), std::stoul(attempts.substr(1)));
        EXPECT_TRUE(matches(got, probability.get<double>(), c.tolerance))
            << h << " " << attempts << " " << rate;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 72);
}

/// Pass rate of a person whose attempts depend on the one before, by summing over all courses.
double byEnumeration(const LcCusumDesign& design, double failureRate, int attempts) {
  double passed = 0.0;
  for (unsigned course = 0; course < 1U << static_cast<unsigned>(attempts); ++course) {
    std::vector<bool> failed;
    double probability = 1.0;
    for (int i = 0; i < attempts; ++i) {
      const bool now = (course >> static_cast<unsigned>(i) & 1U) != 0;
      const double lag = design.dependence.lag;
      const double fails = i == 0 ? failureRate : (1.0 - lag) * failureRate + (failed.back() ? lag : 0.0);
      probability *= now ? fails : 1.0 - fails;
      failed.push_back(now);
    }
    passed += lcCusum(failed, design).competentAt ? probability : 0.0;
  }
  return passed;
}

TEST(LcCusumProbability, OfSuccessiveAttemptsThatCorrelate) {
  const LcCusumDesign design{0.1, 0.3, 1.2, {.lag = 0.4}};
  EXPECT_NEAR(lcCusumProbability(design, 0.3, 14), byEnumeration(design, 0.3, 14), 1e-12);
  const LcCusumDesign alone{0.1, 0.3, 1.2};
  EXPECT_NEAR(lcCusumProbability(alone, 0.3, 14), byEnumeration(alone, 0.3, 14), 1e-12);
}

TEST(LcCusumProbability, OfSessionsWithRatesOfTheirOwn) {
  // Two sessions of three attempts, all of which must succeed: the square of E[(1 - p)^3] of a beta
  // distribution.
  const LcCusumDesign design{0.1, 0.3, 6.0 * std::log(0.9 / 0.7), {.session = 0.25, .perSession = 3}};
  const double a = 0.3 * 3.0;
  const double b = 0.7 * 3.0;
  const double three = b / (a + b) * (b + 1.0) / (a + b + 1.0) * (b + 2.0) / (a + b + 2.0);
  EXPECT_NEAR(lcCusumProbability(design, 0.3, 6), three * three, 1e-13);
  // A long course in closed form, against one step by step.
  const LcCusumDesign many{0.1, 0.3, 6.0, {.session = 0.2, .lag = 0.1, .perSession = 4}};
  const double some = 1.0 - lcCusumProbability(many, 0.3, 1000);
  const double more = 1.0 - lcCusumProbability(many, 0.3, 1500);
  const double most = 1.0 - lcCusumProbability(many, 0.3, 2000);
  EXPECT_NEAR(more / some, most / more, 1e-9);
}

/// Attempts of people with different failure rates, who depend on each other as asked for.
std::vector<SessionOutcomes> simulatedPeople(const AttemptDependence& made, int count, int sessionsOfEach,
                                             Random& random) {
  std::vector<SessionOutcomes> people;
  for (int person = 0; person < count; ++person) {
    const double rate = 0.3 + 0.2 * (person % 5) / 4.0;
    SessionOutcomes sessions;
    bool failed = random.uniform() < rate;
    for (int session = 0; session < sessionsOfEach; ++session) {
      // Two rates with the mean and the variance asked for.
      const double apart = std::sqrt(made.session * rate * (1.0 - rate));
      const double own = random.uniform() < 0.5 ? rate + apart : rate - apart;
      sessions.emplace_back();
      for (std::int64_t i = 0; i < made.perSession; ++i) {
        failed = random.uniform() < made.lag ? failed : random.uniform() < own;
        sessions.back().push_back(failed);
      }
    }
    people.push_back(sessions);
  }
  return people;
}

TEST(EstimateDependence, FindsWhatSimulatedPeopleWereMadeWith) {
  for (const AttemptDependence& made :
       {AttemptDependence{0.0, 0.0, 5}, AttemptDependence{0.3, 0.0, 5}, AttemptDependence{0.0, 0.4, 5},
        AttemptDependence{0.2, 0.2, 4}, AttemptDependence{0.0, 0.3, 1}}) {
    Random random(20261129);
    std::vector<SessionOutcomes> people = simulatedPeople(made, 1000, 10, random);
    const EstimatedDependence got = estimateDependence(people);
    ASSERT_TRUE(got.dependence);
    EXPECT_NEAR(got.dependence->session, made.session, 0.06) << made.session << " " << made.lag;
    EXPECT_NEAR(got.dependence->lag, made.lag, 0.06) << made.session << " " << made.lag;
    EXPECT_EQ(got.dependence->perSession, made.perSession);
    EXPECT_EQ(got.people, 1000);
    EXPECT_EQ(got.attempts, 10'000 * made.perSession);
    people.resize(9);
    EXPECT_FALSE(estimateDependence(people).dependence);  // too few people
    EXPECT_EQ(estimateDependence(people).runsOfSession, made.perSession);
  }
  EXPECT_FALSE(estimateDependence(std::vector<SessionOutcomes>(100, SessionOutcomes{{false, false, false}}))
                   .dependence);
}

TEST(EstimateDependence, IsSeldomTooLowAfterAFewHundredAttempts) {
  const AttemptDependence made{0.25, 0.0, 5};
  Random random(40);
  int high = 0;
  constexpr int kCentres = 200;
  for (int centre = 0; centre < kCentres; ++centre) {
    high +=
        estimateDependence(simulatedPeople(made, 20, 5, random)).dependence->session >= made.session ? 1 : 0;
  }
  EXPECT_GE(high, kCentres * 88 / 100);
}

TEST(EstimateDependence, CountsTheSessionOfATypicalAttempt) {
  // Of 24 attempts 20 were made in one session: (20 * 20 + 4 * 1) / 24.
  const SessionOutcomes person{std::vector<bool>(20, true), {true}, {false}, {true}, {false}};
  EXPECT_EQ(estimateDependence(std::vector<SessionOutcomes>{person}).runsOfSession, 17);
  EXPECT_EQ(estimateDependence({}).runsOfSession, 0);
}

TEST(ChooseLcCusumLimit, KeepsTheFalsePassRate) {
  const std::optional<double> limit = chooseLcCusumLimit({0.1, 0.2}, 50, 0.05);
  ASSERT_TRUE(limit.has_value());
  // At h = 3 the rate is 0.036 (exact table); the chosen limit is the smallest that keeps 0.05.
  EXPECT_LE(*limit, 3.0);
  EXPECT_LE(lcCusumProbability({0.1, 0.2, *limit}, 0.2, 50), 0.05);
  EXPECT_GT(lcCusumProbability({0.1, 0.2, *limit - 0.01}, 0.2, 50), 0.05);
  EXPECT_FALSE(chooseLcCusumLimit({0.1, 0.2}, 3, 0.05).has_value());
  const std::optional<double> ofMany = chooseLcCusumLimit({0.1, 0.2}, 10'000, 0.05);
  ASSERT_TRUE(ofMany.has_value());
  EXPECT_LE(lcCusumProbability({0.1, 0.2, *ofMany}, 0.2, 10'000), 0.05);
  EXPECT_GT(lcCusumProbability({0.1, 0.2, *ofMany - 0.01}, 0.2, 10'000), 0.05);
}

TEST(WatchForRelapse, AlarmsAfterFailuresAndNotAfterSuccesses) {
  EXPECT_FALSE(watchForRelapse(std::vector<bool>(50, false), {0.1, 0.2, 1.25}).alarmAt.has_value());
  EXPECT_EQ(watchForRelapse({false, true, true, true}, {0.1, 0.2, 1.25}).alarmAt,
            3U);  // 2 ln 2 = 1.386 >= 1.25
}

TEST(ContrastingGroups, AgreesForTheNormalAndTheLogisticCut) {
  const ReferenceCase c = referenceCase("learning", "contrasting_groups");
  std::vector<double> novices;
  std::vector<double> masters;
  for (std::size_t i = 0; i < c.input.at("score").size(); ++i) {
    (c.input.at("master")[i].get<int>() == 1 ? masters : novices)
        .push_back(c.input.at("score")[i].get<double>());
  }
  const Outcome<ContrastingGroups> got = contrastingGroups(novices, masters);
  const auto expectValue = [&](const char* name, double value) {
    EXPECT_TRUE(matches(value, c.expected.at(name).get<double>(), c.tolerance)) << name;
  };
  expectValue("cut_normal_intersection", got->cutNormal);
  expectValue("cut_logistic50", got->cutLogistic.value());
  expectValue("false_pos_normal", got->falsePass);
  expectValue("false_neg_normal", got->falseFail);
  expectValue("midpoint", got->midpoint);
  EXPECT_TRUE(matches(got->otherRoot.value(), c.expected.at("roots")[0].get<double>(), c.tolerance));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(matches(got->logistic[i], c.expected.at("logit_coef")[i].get<double>(), c.tolerance));
    // R stops iterating at a relative change of 1e-8, which affects its standard errors.
    EXPECT_TRUE(matches(got->logisticErrors[i], c.expected.at("logit_se")[i].get<double>(), 1e-5));
  }
}

TEST(ContrastingGroups, HasNoLogisticCutIfTheGroupsDoNotOverlap) {
  const std::vector<double> novices = {1, 2, 3};
  const std::vector<double> masters = {11, 12, 14};
  EXPECT_FALSE(contrastingGroups(novices, masters)->cutLogistic.has_value());
  EXPECT_FALSE(contrastingGroups(masters, novices));
}

TEST(Angoff, AgreesWithTheJudges) {
  const ReferenceCase c = referenceCase("learning", "angoff");
  const Outcome<Angoff> got =
      angoff(NumberTable(c.input.at("judge_by_item_percent").get<std::vector<std::vector<double>>>()));
  EXPECT_TRUE(matches(got->cut, c.expected.at("cut_raw").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(got->percent, c.expected.at("cut_percent").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(*got->deviation, c.expected.at("sd_judges").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(*got->error, c.expected.at("se_judges").get<double>(), c.tolerance));
}

TEST(BorderlineRegression, PredictsTheScoreAtTheBorderlineRating) {
  // Exact line: score = 10 + 12 x rating, with +-1 uncorrelated with the rating.
  const std::vector<double> rating = {1, 1, 2, 2, 3, 3};
  const std::vector<double> score = {21, 23, 33, 35, 45, 47};
  const Outcome<BorderlineRegression> got = borderlineRegression(rating, score, 2.0);
  EXPECT_NEAR(got->cut, 34.0, 1e-12);
  EXPECT_NEAR(got->slope, 12.0, 1e-12);
  EXPECT_FALSE(borderlineRegression(std::vector<double>{2, 2, 2}, std::vector<double>{1, 2, 3}, 2.0));
}

TEST(ProficiencyThreshold, AgreesWithTheToleranceTables) {
  const ReferenceCase c = referenceCase("learning", "proficiency_threshold");
  const Outcome<ProficiencyThreshold> got = proficiencyThreshold(numbers(c.input.at("expert_times_s")));
  const auto expectValue = [&](const char* name, double value) {
    EXPECT_TRUE(matches(value, c.expected.at(name).get<double>(), c.tolerance)) << name;
  };
  expectValue("mean", got->mean);
  expectValue("sd", got->deviation);
  expectValue("mean_plus_sd", got->oneDeviation);
  expectValue("mean_plus_2sd", got->twoDeviations);
  expectValue("k_factor", got->toleranceFactor);
  expectValue("upper_tol", got->toleranceBound);
}

TEST(ProficientAt, RequiresConsecutiveAndFurtherPasses) {
  const std::vector<double> times = {60, 40, 50, 39, 38, 50, 41};
  EXPECT_EQ(proficientAt(times, 42.0, Better::kLower), 5U);
  EXPECT_EQ(proficientAt(times, 42.0, Better::kLower, 2, 1), 7U);
  EXPECT_FALSE(proficientAt(times, 42.0, Better::kLower, 3).has_value());
}

}  // namespace
}  // namespace torsio
