// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/statistics/generalizability.h"
#include "assessment/statistics/rasch.h"
#include "assessment/statistics/rating_scale.h"
#include "sim/core/error.h"
#include "sim/core/random.h"
#include "tests/assessment/reference_case.h"

namespace torsio {
namespace {

using Rows = std::vector<std::vector<double>>;
using test::matches;
using test::ReferenceCase;
using test::referenceCase;

TEST(GStudy, AgreesWithBrennansRatersInTasks) {
  const ReferenceCase c = referenceCase("generalizability", "g_brennan_synth4_p_x_r_in_t");
  std::vector<NumberTable> byTask(3, NumberTable(10, 4));
  const nlohmann::json& data = c.input.at("persons_by_(task*4+rater)");
  for (std::size_t p = 0; p < 10; ++p) {
    for (std::size_t j = 0; j < 12; ++j) {
      byTask[j / 4].at(p, j % 4) = data[p][j].get<double>();
    }
  }

  const Outcome<GStudy> got = gStudyPRinT(byTask);

  const std::vector<std::pair<const char*, const char*>> names = {
      {"p", "p"}, {"t", "t"}, {"rt", "r:t"}, {"pt", "pt"}, {"prt", "pr:t"}};
  for (const auto& [key, effect] : names) {
    EXPECT_TRUE(matches(got->at(effect).sumOfSquares, c.expected.at("SS").at(key).get<double>(), c.tolerance))
        << key;
    EXPECT_TRUE(matches(got->at(effect).meanSquare, c.expected.at("MS").at(key).get<double>(), c.tolerance))
        << key;
    EXPECT_TRUE(matches(got->at(effect).variance, c.expected.at("var").at(key).get<double>(), c.tolerance))
        << key;
    EXPECT_EQ(got->at(effect).df, c.expected.at("df").at(key).get<double>());
  }
  const Outcome<DStudy> d = dStudyPRinT(*got, 3, 4);
  EXPECT_TRUE(matches(d->relativeError, c.expected.at("rel_err").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(d->absoluteError, c.expected.at("abs_err").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(d->generalizability, c.expected.at("Erho2").get<double>(), c.tolerance));
  EXPECT_TRUE(matches(d->dependability, c.expected.at("Phi").get<double>(), c.tolerance));
}

TEST(GStudy, AgreesWithBrennansCrossedDesign) {
  const ReferenceCase c = referenceCase("generalizability", "g_brennan_synth3_p_x_i_x_o");
  std::vector<NumberTable> byOccasion(2, NumberTable(10, 4));
  for (std::size_t o = 0; o < 2; ++o) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t p = 0; p < 10; ++p) {
        byOccasion[o].at(p, i) = c.input.at("o_i_p")[o][i][p].get<double>();
      }
    }
  }

  const Outcome<GStudy> got = gStudyPRO(byOccasion);

  const std::vector<std::pair<const char*, const char*>> names = {
      {"p", "p"}, {"i", "r"}, {"o", "o"}, {"pi", "pr"}, {"po", "po"}, {"io", "ro"}, {"pio", "pro"}};
  for (const auto& [key, effect] : names) {
    EXPECT_TRUE(matches(got->at(effect).sumOfSquares, c.expected.at("SS").at(key).get<double>(), c.tolerance))
        << key;
    EXPECT_TRUE(matches(got->at(effect).variance, c.expected.at("var").at(key).get<double>(), c.tolerance))
        << key;
  }
  for (const auto& [key, raters, occasions] : std::vector<std::tuple<const char*, double, double>>{
           {"D_4_2", 4, 2}, {"D_1_1", 1, 1}, {"D_10_1", 10, 1}, {"D_10_3", 10, 3}}) {
    const Outcome<DStudy> d = dStudyPRO(*got, raters, occasions);
    const nlohmann::json& expected = c.expected.at(key);
    EXPECT_TRUE(matches(d->relativeError, expected.at("rel_err").get<double>(), c.tolerance)) << key;
    EXPECT_TRUE(matches(d->absoluteError, expected.at("abs_err").get<double>(), c.tolerance)) << key;
    EXPECT_TRUE(matches(d->generalizability, expected.at("Erho2").get<double>(), c.tolerance)) << key;
    EXPECT_TRUE(matches(d->dependability, expected.at("Phi").get<double>(), c.tolerance)) << key;
  }
}

TEST(GStudy, AgreesOnTheSyntheticTrainingStudy) {
  const ReferenceCase c = referenceCase("training_study", "training_study_synthetic");
  std::vector<NumberTable> byOccasion(3, NumberTable(30, 10));
  for (std::size_t g = 0; g < 3; ++g) {
    for (std::size_t i = 0; i < 10; ++i) {
      for (std::size_t t = 0; t < 3; ++t) {
        for (std::size_t r = 0; r < 10; ++r) {
          byOccasion[t].at(10 * g + i, r) = c.input.at("data_g_i_t_r")[g][i][t][r].get<double>();
        }
      }
    }
  }
  const Outcome<GStudy> got = gStudyPRO(byOccasion);
  for (const char* effect : {"p", "r", "o", "pr", "po", "ro", "pro"}) {
    EXPECT_TRUE(matches(got->at(effect).variance,
                        c.expected.at("g_study_p_r_o").at("var").at(effect).get<double>(), 1e-9))
        << effect;
  }
  const Outcome<DStudy> d = dStudyPRO(*got, 10, 3);
  EXPECT_TRUE(matches(d->generalizability,
                      c.expected.at("g_study_p_r_o").at("D_r10_o3").at("Erho2").get<double>(), 1e-9));
  EXPECT_TRUE(
      matches(d->dependability, c.expected.at("g_study_p_r_o").at("D_r10_o3").at("Phi").get<double>(), 1e-9));
}

TEST(GStudy, ReportsNegativeComponentsAndUsesZeroOnlyForTheDStudy) {
  // Persons differ less than expected by chance: the interaction exceeds the person effect.
  const Outcome<GStudy> got = gStudyPR(NumberTable({{1, 5}, {5, 1}, {3, 3}}));
  EXPECT_LT(got->at("p").variance, 0.0);
  EXPECT_TRUE(got->negativeComponent);
  EXPECT_EQ(dStudyPR(*got, 10)->generalizability, 0.0);
  EXPECT_FALSE(gStudyPR(NumberTable(Rows{{1, 5}})));
}

std::vector<std::vector<std::optional<int>>> ratingsOf(const nlohmann::json& rows) {
  std::vector<std::vector<std::optional<int>>> out;
  for (const nlohmann::json& row : rows) {
    out.emplace_back();
    for (const nlohmann::json& mark : row) {
      out.back().emplace_back(mark.get<int>());
    }
  }
  return out;
}

TEST(ManyFacetRasch, AgreesWithNewtonAndThePoissonModel) {
  const ReferenceCase c = referenceCase("rasch", "mfrm_jml_12x4");
  const Outcome<RaschResult> got = manyFacetRasch(ratingsOf(c.input.at("ratings_0_4")), 4);
  ASSERT_TRUE(got) << got.reason().str();
  for (std::size_t n = 0; n < 12; ++n) {
    const RaschPerson& person = got->persons[n];
    EXPECT_TRUE(matches(*person.ability, c.expected.at("theta")[n].get<double>(), c.tolerance));
    EXPECT_TRUE(matches(*person.error, c.expected.at("se_theta")[n].get<double>(), c.tolerance));
    EXPECT_TRUE(matches(*person.jointError, c.expected.at("joint_se")[n].get<double>(), c.tolerance));
    EXPECT_TRUE(matches(*person.infit, c.expected.at("infit_person")[n].get<double>(), c.tolerance));
    EXPECT_TRUE(matches(*person.outfit, c.expected.at("outfit_person")[n].get<double>(), c.tolerance));
  }
  for (std::size_t r = 0; r < 4; ++r) {
    const RaschRater& rater = got->raters[r];
    EXPECT_TRUE(matches(*rater.severity, c.expected.at("severity")[r].get<double>(), c.tolerance));
    EXPECT_TRUE(matches(*rater.error, c.expected.at("se_severity")[r].get<double>(), c.tolerance));
    EXPECT_TRUE(matches(*rater.infit, c.expected.at("infit_rater")[r].get<double>(), c.tolerance));
    EXPECT_TRUE(matches(*rater.outfit, c.expected.at("outfit_rater")[r].get<double>(), c.tolerance));
    EXPECT_TRUE(matches(got->thresholds[r], c.expected.at("tau")[r].get<double>(), c.tolerance));
  }
  EXPECT_TRUE(matches(got->logLikelihood, c.expected.at("loglik").get<double>(), c.tolerance));
}

TEST(RatingScale, KeepsItsDigitsIfNeighboursAreFarApart) {
  CategoryOdds at;
  RatingScale({0.4, -1.1, 0.7}).at(0.3, at);  // near: by ratios
  const std::vector<double> weights = {1.0, std::exp(-0.1), std::exp(1.3), std::exp(0.9)};
  const double sum = weights[0] + weights[1] + weights[2] + weights[3];
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(at.p[k], weights[k] / sum, 1e-15);
  }
  // Everything between the ends is less likely by up to e^800 or e^580: half and half, mean 2, variance 4.
  for (const double far : {400.0, 290.0}) {
    RatingScale({far, far, -far, -far}).at(0.0, at);
    EXPECT_DOUBLE_EQ(at.p[0], 0.5);
    EXPECT_DOUBLE_EQ(at.p[4], 0.5);
    EXPECT_DOUBLE_EQ(at.mean, 2.0);
    EXPECT_DOUBLE_EQ(at.variance, 4.0);
  }
  RatingScale({1.0, -1.0}).at(-900.0, at);
  EXPECT_DOUBLE_EQ(at.p[0], 1.0);
  EXPECT_EQ(at.mean, 0.0);
}

TEST(ManyFacetRasch, RemovesAndReportsExtremePersons) {
  std::vector<std::vector<std::optional<int>>> ratings =
      ratingsOf(referenceCase("rasch", "mfrm_jml_12x4").input.at("ratings_0_4"));
  const Outcome<RaschResult> without = manyFacetRasch(ratings, 4);
  ratings.push_back({4, 4, 4, 4});
  ratings.push_back({0, 0, 0, 0});
  ratings.push_back({std::nullopt, std::nullopt, std::nullopt, std::nullopt});
  const Outcome<RaschResult> with = manyFacetRasch(ratings, 4);
  EXPECT_EQ(with->persons[12].status, RaschStatus::kExtremeHigh);
  EXPECT_EQ(with->persons[13].status, RaschStatus::kExtremeLow);
  EXPECT_EQ(with->persons[14].status, RaschStatus::kNoRatings);
  EXPECT_FALSE(with->persons[12].ability.has_value());
  EXPECT_NEAR(*with->raters[0].severity, *without->raters[0].severity, 1e-10);
}

TEST(ManyFacetRasch, RejectsDisconnectedPlansUnusedCategoriesAndOrderlyData) {
  const std::optional<int> hole;
  const Outcome<RaschResult> apart =
      manyFacetRasch({{0, 1, hole, hole}, {1, 0, hole, hole}, {hole, hole, 0, 1}, {hole, hole, 1, 0}}, 1);
  EXPECT_THAT(apart.reason().str(), ::testing::HasSubstr("parts"));
  EXPECT_THAT(manyFacetRasch({{0, 1}, {1, 0}, {3, 1}}, 3).reason().str(), ::testing::HasSubstr("collapse"));
  EXPECT_THAT(manyFacetRasch({{0, 1}, {0, 1}, {0, 1}}, 1).reason().str(),
              ::testing::HasSubstr("fewer than two"));
  EXPECT_THROW((void)manyFacetRasch({{0, 5}, {1, 2}}, 3), Error);
}

TEST(ManyFacetRasch, EstimatesAnIncompletePlan) {
  std::vector<std::vector<std::optional<int>>> ratings =
      ratingsOf(referenceCase("rasch", "mfrm_jml_12x4").input.at("ratings_0_4"));
  ratings[2][3] = std::nullopt;
  ratings[9][0] = std::nullopt;
  const Outcome<RaschResult> got = manyFacetRasch(ratings, 4);
  ASSERT_TRUE(got) << got.reason().str();
  double sum = 0.0;
  for (const RaschRater& rater : got->raters) {
    sum += *rater.severity;
  }
  EXPECT_NEAR(sum, 0.0, 1e-12);
  // A fair average is independent of which raters were drawn: higher ability, higher fair average.
  EXPECT_GT(*got->persons[10].fairAverage, *got->persons[3].fairAverage);
}

using Marks = std::vector<std::vector<std::optional<int>>>;

/// True if no person or rater is extreme and every category is used: conditions that the model checks before
/// it searches for a maximum.
bool plain(const Marks& marks, int highest) {
  std::vector<int> used(static_cast<std::size_t>(highest) + 1, 0);
  const auto extreme = [&](const std::vector<std::optional<int>>& line) {
    int low = highest;
    int high = 0;
    for (const std::optional<int>& mark : line) {
      low = std::min(low, mark.value_or(low));
      high = std::max(high, mark.value_or(high));
    }
    return high == 0 || low == highest;
  };
  for (const auto& person : marks) {
    if (extreme(person)) {
      return false;
    }
    for (const std::optional<int>& mark : person) {
      used[static_cast<std::size_t>(mark.value_or(0))] += mark.has_value() ? 1 : 0;
    }
  }
  for (std::size_t r = 0; r < marks.front().size(); ++r) {
    std::vector<std::optional<int>> column;
    for (const auto& person : marks) {
      column.push_back(person[r]);
    }
    if (extreme(column)) {
      return false;
    }
  }
  return std::count(used.begin(), used.end(), 0) == 0;
}

/// Six persons, three raters, categories 0 to 3, a sixth of the marks missing.
Marks randomMarks(Random& random) {
  for (;;) {
    Marks marks(6, std::vector<std::optional<int>>(3));
    for (auto& person : marks) {
      const int skill = static_cast<int>(random.bounded(3));
      for (auto& mark : person) {
        if (random.bounded(6) != 0) {
          mark = std::clamp(skill + static_cast<int>(random.bounded(3)) - 1, 0, 3);
        }
      }
    }
    if (plain(marks, 3)) {
      return marks;
    }
  }
}

/// True if abilities, severities 0, b1, b2 and thresholds 0, t2, t3 can all grow in this proportion without
/// making any mark less likely. Far out the most likely category is the one whose thresholds enclose ability
/// - severity.
bool mayGrow(const Marks& marks, const std::array<int, 3>& severity, const std::array<int, 3>& threshold) {
  constexpr int kFar = 1000;
  for (const auto& person : marks) {
    int low = -kFar;
    int high = kFar;
    for (std::size_t r = 0; r < 3; ++r) {
      if (const std::optional<int> mark = person[r]) {
        low = *mark > 0 ? std::max(low, severity[r] + threshold[static_cast<std::size_t>(*mark) - 1]) : low;
        high = *mark < 3 ? std::min(high, severity[r] + threshold[static_cast<std::size_t>(*mark)]) : high;
      }
    }
    if (low > high) {
      return false;
    }
  }
  return true;
}

/// Tries all directions of small integers: the edges of a cone bounded by differences of four unknowns have
/// no larger ones.
bool growsForEver(const Marks& marks) {
  constexpr int kReach = 4;
  for (int b1 = -kReach; b1 <= kReach; ++b1) {
    for (int b2 = -kReach; b2 <= kReach; ++b2) {
      for (int t2 = 0; t2 <= kReach; ++t2) {
        for (int t3 = t2; t3 <= kReach; ++t3) {
          const bool still = b1 == 0 && b2 == 0 && t2 == 0 && t3 == 0;
          if (!still && mayGrow(marks, {0, b1, b2}, {0, t2, t3})) {
            return true;
          }
        }
      }
    }
  }
  return false;
}

TEST(ManyFacetRasch, IsEstimatedExactlyIfTheLikelihoodHasAFiniteMaximum) {
  Random random(400);
  int refused = 0;
  int wrong = 0;
  for (int set = 0; set < 400; ++set) {
    const Marks marks = randomMarks(random);
    const bool endless = growsForEver(marks);

    const Outcome<RaschResult> got = manyFacetRasch(marks, 3);

    refused += endless ? 1 : 0;
    wrong += static_cast<bool>(got) == endless ? 1 : 0;
    EXPECT_EQ(static_cast<bool>(got), !endless) << "set " << set << ": " << got.reason().str();
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, 400);
  EXPECT_EQ(wrong, 0) << "of 400, " << refused << " without a finite maximum";
}

TEST(ManyFacetRasch, NamesUnboundedRaters) {
  // Raters 1 and 2 bound each other, and so do 3 and 4. The only person rated by both pairs has 0 from 1 and
  // 1 from 3: a connected plan, but 3 and 4 may be more lenient than 1 and 2 by any amount.
  const std::optional<int> hole;
  const Marks marks = {
      {0, 1, hole, hole}, {1, 0, hole, hole}, {hole, hole, 0, 1}, {hole, hole, 1, 0}, {0, hole, 1, hole}};

  const Outcome<RaschResult> got = manyFacetRasch(marks, 1);

  ASSERT_FALSE(got);
  EXPECT_THAT(got.reason().str(), ::testing::HasSubstr("bounds rater 3 and rater 4"));
  const std::vector<std::string> codes{"R-01", "R-02", "R-03", "R-04"};
  EXPECT_THAT(manyFacetRasch(marks, 1, codes).reason().str(), ::testing::HasSubstr("bounds R-03 and R-04"));
}

TEST(Rasch, CorrectedSeveritiesAreLessFarApartAndTheirIntervalsHoldTheTruth) {
  // Thirty persons, three raters whose severities are -0.7, 0.1 and 0.6, five categories.
  const double severity[] = {-0.7, 0.1, 0.6};
  std::uint64_t state = 11;
  const auto uniform = [&] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11U) / 9007199254740992.0;
  };
  int held = 0;
  int all = 0;
  double along = 0.0;
  double joint = 0.0;
  for (int set = 0; set < 60; ++set) {
    CategoryRatings ratings;
    for (int i = 0; i < 30; ++i) {
      const double ability = 1.2 * (uniform() + uniform() + uniform() - 1.5) * 2.0;
      ratings.emplace_back();
      for (const double strict : severity) {
        double weights[5] = {1.0};
        double sum = 1.0;
        for (int k = 1; k < 5; ++k) {
          weights[k] = weights[k - 1] * std::exp(ability - strict + 2.0 - 4.0 * (k - 1) / 3.0);
          sum += weights[k];
        }
        double at = uniform() * sum;
        int k = 0;
        while (k < 4 && (at -= weights[k]) > 0.0) {
          ++k;
        }
        ratings.back().emplace_back(k);
      }
    }
    const Outcome<RaschResult> found = manyFacetRasch(ratings, 4);
    if (!found) {
      continue;
    }
    const auto corrected = correctedSeverities(ratings, *found);
    for (std::size_t r = 0; r < 3; ++r) {
      if (!corrected[r]) {
        continue;
      }
      ++all;
      held +=
          corrected[r]->interval.lower <= severity[r] && severity[r] <= corrected[r]->interval.upper ? 1 : 0;
      along += severity[r] * corrected[r]->severity;
      joint += severity[r] * *found->raters[r].severity;
    }
  }
  const double squares = static_cast<double>(all) / 3.0 * (0.49 + 0.01 + 0.36);
  ASSERT_GT(all, 150);
  EXPECT_GT(joint / squares, 1.4);   // joint estimates are half as far apart again
  EXPECT_LT(along / squares, 1.25);  // corrected ones are nearly right
  EXPECT_GE(held, all * 92 / 100);
}

}  // namespace
}  // namespace torsio
