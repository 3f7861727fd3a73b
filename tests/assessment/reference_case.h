// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/rank_tests.h"
#include "assessment/statistics/values.h"

namespace torsio::test {

/// A case of tests/data/assessment: input, expected values, and their relative tolerance.
struct ReferenceCase {
  nlohmann::json input;
  nlohmann::json expected;
  double tolerance = 0.0;
};

inline ReferenceCase referenceCase(const std::string& family, const std::string& id) {
  const std::string path = std::string(TORSIO_TEST_DATA) + "/assessment/" + family + ".json";
  std::ifstream file(path);
  if (!file) {
    throw std::runtime_error("cannot read " + path);
  }
  const nlohmann::json all = nlohmann::json::parse(file);
  const nlohmann::json& found = all.at(id);
  return {found.at("input"), found.at("expected"), found.at("relative_tolerance").get<double>()};
}

/// |got - expected| <= tolerance * max(1e-12, |expected|), but at least an absolute 1e-12 for true zeros.
inline ::testing::AssertionResult matches(double got, double expected, double tolerance) {
  const double allowed = expected == 0.0 ? 1e-12 : tolerance * std::max(1e-12, std::abs(expected));
  if (std::isfinite(got) && std::abs(got - expected) <= allowed) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << std::scientific << "got " << ::testing::PrintToString(got)
                                       << ", expected " << ::testing::PrintToString(expected)
                                       << ", difference " << got - expected << ", allowed " << allowed;
}

inline std::vector<double> numbers(const nlohmann::json& list) {
  return list.get<std::vector<double>>();
}

// Reference data of group comparisons, and the names of their values.

/// Compares numbers with the named values of a case.
struct Expect {
  const nlohmann::json& expected;
  double tolerance;

  void value(const char* name, double got) const {
    EXPECT_TRUE(matches(got, expected.at(name).get<double>(), tolerance)) << name;
  }
  void interval(const char* name, const Interval& got) const {
    EXPECT_TRUE(matches(got.lower, expected.at(name)[0].get<double>(), tolerance)) << name;
    EXPECT_TRUE(matches(got.upper, expected.at(name)[1].get<double>(), tolerance)) << name;
  }
};

/// Compares a t test with a case.
inline void expectTTest(const TTest& got, const Expect& expect) {
  expect.value("diff", got.difference);
  expect.value("se", got.error);
  expect.value("t", got.t);
  expect.value("df", got.df);
  expect.value("p", got.p);
  expect.interval("ci", got.interval);
}

/// Compares an effect size and its intervals with a case.
inline void expectHedges(const HedgesG& got, const Expect& expect) {
  expect.value("d", got.d);
  expect.value("J_exact", got.correction);
  expect.value("g", got.g);
  expect.interval("ncp_ci", got.noncentrality);
  expect.interval("d_ci_nct", got.dInterval);
  expect.interval("g_ci_nct", got.interval);
  expect.value("se_g", got.error);
  expect.interval("g_ci_normal", got.normalInterval);
}

/// Compares a Mann-Whitney test with a case; scores are multiples of `unit`.
inline void expectMannWhitney(const MannWhitney& got, const Expect& expect, double unit = 1.0) {
  expect.value("U", got.u);
  expect.value("A12", got.superiority);
  EXPECT_NEAR(got.cliffDelta, expect.expected.at("cliff_delta").get<double>(), 1e-12);
  EXPECT_EQ(got.ties, expect.expected.at("ties").get<bool>());
  expect.value("z_cc", got.zCorrected);
  expect.value("p_norm_cc", got.pCorrected);
  expect.value("z", got.z);
  expect.value("p_norm", got.pNormal);
  EXPECT_EQ(got.countTwoSided, expect.expected.at("exact_count_two").get<std::int64_t>());
  EXPECT_EQ(got.arrangements, expect.expected.at("exact_total").get<std::int64_t>());
  EXPECT_EQ(got.countGreater, expect.expected.at("exact_count_greater").get<std::int64_t>());
  expect.value("p_exact_two", *got.pExact);
  expect.value("p_exact_greater", *got.pGreater);
  expect.value("hodges_lehmann", got.hodgesLehmann * unit);
}

/// Compares a Kruskal-Wallis test and Dunn's pairs with a case.
inline void expectKruskal(const KruskalWallis& got, const nlohmann::json& kw, const nlohmann::json& dunn,
                          double tolerance) {
  const Expect expect{kw, tolerance};
  expect.value("H_uncorrected", got.hUncorrected);
  expect.value("C", got.tieCorrection);
  expect.value("H", got.h);
  expect.value("p", got.p);
  expect.value("epsilon2", got.epsilonSquared);
  expect.value("eta2_H", got.etaSquaredH);
  expect.value("T", got.tieTerm);
  for (std::size_t g = 0; g < 3; ++g) {
    EXPECT_TRUE(matches(got.meanRanks[g], kw.at("mean_ranks")[g].get<double>(), tolerance));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Expect pair{dunn[i], tolerance};
    pair.value("diff", got.pairs[i].difference);
    pair.value("se", got.pairs[i].error);
    pair.value("z", got.pairs[i].z);
    pair.value("p", got.pairs[i].p);
    pair.value("p_holm", got.pairs[i].pHolm);
  }
}

/// R's sleep data.
struct Sleep {
  ReferenceCase welch = referenceCase("groups", "welch_sleep");
  std::vector<double> x = numbers(welch.input.at("x"));
  std::vector<double> y = numbers(welch.input.at("y"));
};

/// R's PlantGrowth data: three groups of ten.
struct PlantGrowth {
  ReferenceCase reference = referenceCase("groups", "plantgrowth_three_groups_of_ten");
  Groups groups = {numbers(reference.input.at("ctrl")), numbers(reference.input.at("trt1")),
                   numbers(reference.input.at("trt2"))};
  const char* names[3] = {"ctrl-trt1", "ctrl-trt2", "trt1-trt2"};
  std::size_t first[3] = {0, 0, 1};
  std::size_t second[3] = {1, 2, 2};
};

/// The synthetic training study: three groups, three occasions.
struct Study {
  ReferenceCase reference = referenceCase("training_study", "training_study_synthetic");
  std::vector<Groups> scores;  // group, trainee, occasion
  Study() : scores(reference.expected.at("intern_scores_g_i_t").get<std::vector<Groups>>()) {}

  [[nodiscard]] Groups occasion(std::size_t t) const {
    Groups out;
    for (const Groups& group : scores) {
      out.emplace_back();
      for (const std::vector<double>& trainee : group) {
        out.back().push_back(trainee[t]);
      }
    }
    return out;
  }
  [[nodiscard]] Groups gainsInTenths() const {
    Groups out;
    for (const Groups& group : scores) {
      out.emplace_back();
      for (const std::vector<double>& trainee : group) {
        out.back().push_back(std::round(10.0 * trainee[2]) - std::round(10.0 * trainee[0]));
      }
    }
    return out;
  }
};

}  // namespace torsio::test
