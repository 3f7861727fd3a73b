// SPDX-License-Identifier: GPL-3.0-or-later
// Paired scores, resampling and adjusted pairs against the reference cases of tests/data/assessment.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/app/cli/table_commands.h"
#include "tests/assessment/reference_case.h"

namespace torsio {
namespace {

using nlohmann::json;
using test::addRow;
using test::expectMatch;
using test::named;
using test::numbers;
using test::occasions;
using test::ReferenceCase;
using test::referenceCase;
using ComparisonCommands = test::TableCommands;

TEST_F(ComparisonCommands, PairedSignedRankAgreesWithHollanderAndWolfe) {
  const ReferenceCase c = referenceCase("groups", "signed_rank_hollander_wolfe");
  const std::string file = write(
      "depression.csv", occasions({"second", "first"}, {numbers(c.input.at("y")), numbers(c.input.at("x"))}));

  const json out = answer("compare-groups --paired signed-rank " + file);

  const json& test = out["groups"][0]["test"];
  EXPECT_EQ(out["groups"][0]["group"], "all");
  expectMatch(test["statistic"], c.expected.at("V"), c.tolerance, "V");
  expectMatch(test["p"], c.expected.at("p_two"), c.tolerance, "p");
  expectMatch(test["p_greater"], c.expected.at("p_greater"), c.tolerance, "p greater");
  expectMatch(test["hodges_lehmann"], c.expected.at("hodges_lehmann"), c.tolerance, "Hodges-Lehmann");
  EXPECT_NEAR(test["effect_size"]["value"].get<double>(), 2.0 * 40.0 / 45.0 - 1.0,
              1e-12);  // of 9 x 10 / 2 = 45
}

TEST_F(ComparisonCommands, PairedFriedmanAgreesWithHollanderAndWolfe) {
  const ReferenceCase c = referenceCase("groups", "friedman_hollander_wolfe");
  const json& blocks = c.input.at("blocks_by_treatment");
  std::vector<std::vector<double>> columns(3);
  for (const json& block : blocks) {
    for (std::size_t t = 0; t < 3; ++t) {
      columns[t].push_back(block[t].get<double>());
    }
  }

  const json out = answer("compare-groups --paired friedman " +
                          write("bases.csv", occasions({"round", "narrow", "wide"}, columns)));

  const json& test = out["groups"][0]["test"];
  expectMatch(test["statistic"], c.expected.at("chi2"), c.tolerance, "chi squared");
  expectMatch(test["p"], c.expected.at("p"), c.tolerance, "p");
  expectMatch(test["effect_size"]["value"], c.expected.at("kendall_W"), c.tolerance, "W");
  expectMatch(test["iman_davenport"]["p"], c.expected.at("p_F"), c.tolerance, "p of F");
  EXPECT_EQ(test["rank_sums"][1], json({{"occasion", "narrow"}, {"sum", 47.0}}));
}

TEST_F(ComparisonCommands, PairedTAndPermutationAgreeOnDarwinsPlants) {
  const ReferenceCase c = referenceCase("groups", "permutation_darwin");
  const std::vector<double> differences = numbers(c.input.at("d"));
  const std::string file =
      write("darwin.csv", occasions({"self", "cross"}, {std::vector<double>(differences.size(), 100.0), [&] {
                                                          std::vector<double> cross;
                                                          for (const double d : differences) {
                                                            cross.push_back(100.0 + d);
                                                          }
                                                          return cross;
                                                        }()}));

  const json t = answer("compare-groups --paired t " + file)["groups"][0];
  const json permutation = answer("compare-groups --paired permutation " + file)["groups"][0];

  constexpr double kPublishedP = 1e-10;  // of the source program
  expectMatch(t["test"]["statistic"], c.expected.at("t"), c.tolerance, "t");
  expectMatch(t["test"]["p"], c.expected.at("p_t"), kPublishedP, "p of t");
  EXPECT_EQ(permutation["test"]["count"], c.expected.at("count_two"));
  EXPECT_EQ(permutation["test"]["total"], c.expected.at("total"));
  expectMatch(permutation["test"]["p"], c.expected.at("p_two"), c.tolerance, "p");
}

TEST_F(ComparisonCommands, PairedComparisonsCorrelateFirstAndLast) {
  const ReferenceCase c = referenceCase("groups", "jackknife_law_school");
  const std::string file =
      write("law.csv", occasions({"LSAT", "GPA"}, {numbers(c.input.at("LSAT")), numbers(c.input.at("GPA"))}));

  const json correlation = answer("compare-groups --paired t " + file)["groups"][0]["correlation"];

  expectMatch(correlation["r"], c.expected.at("r"), c.tolerance, "r");
  expectMatch(correlation["interval"]["lower"], c.expected.at("fisher_ci")[0], c.tolerance, "lower");
  expectMatch(correlation["interval"]["upper"], c.expected.at("fisher_ci")[1], c.tolerance, "upper");
}

TEST_F(ComparisonCommands, PairedComparisonsSeparateGroupsAndReportMissingScores) {
  // Group one gains 1, 2, 3 and one subject lacks the last score; group two has a single subject.
  const std::string file =
      write("groups.csv",
            "subject,group,occasion,score\n"
            "a,one,pre,1\na,one,post,2\nb,one,pre,1\nb,one,post,3\nc,one,pre,2\nc,one,post,5\n"
            "d,one,pre,4\nd,one,post,\ne,two,pre,4\ne,two,post,4\n");
  const std::string once = write("once.csv", "subject,occasion,score\na,pre,1\nb,pre,2\n");

  const json out = answer("compare-groups --paired signed-rank --bootstrap mean " + file);

  EXPECT_EQ(out["groups"][0]["n"], 3);
  EXPECT_EQ(out["groups"][0]["left_out"], 1);
  EXPECT_EQ(out["groups"][0]["test"]["statistic"], 6.0);  // ranks 1 + 2 + 3
  EXPECT_EQ(out["groups"][0]["test"]["p"], 0.25);         // 2 of 2^3 signs
  EXPECT_TRUE(out["groups"][1]["test"].contains("undefined"));
  EXPECT_EQ(out["bootstrap"]["groups"][0]["estimate"], 2.0);
  EXPECT_TRUE(out["bootstrap"]["groups"][1].contains("undefined"));
  expectRefused("compare-groups --paired t " + once, {"once.csv", "two occasions"});
  for (const char* test : {"t", "signed-rank", "permutation", "friedman"}) {
    const json empty = answer(std::string("compare-groups --paired ") + test + " " +
                              write("none.csv", "subject,occasion,score\na,pre,1\nb,post,2\n"));
    EXPECT_TRUE(empty["groups"][0]["test"].contains("undefined")) << test;
  }
}

TEST_F(ComparisonCommands, BootstrapOfEveryResampleAgreesWithTheEnumeration) {
  const ReferenceCase c = referenceCase("groups", "bootstrap_exact_enumeration");
  std::string table = "subject,group,score\n";
  const std::vector<double> data = numbers(c.input.at("data"));
  for (std::size_t s = 0; s < data.size(); ++s) {
    addRow(table, {named("s", s), "one", json(data[s]).dump()});
  }
  const std::string file = write("five.csv", table);

  const json exact =
      answer("compare-groups --bootstrap mean --every-resample " + file)["bootstrap"]["groups"][0];
  const json median =
      answer("compare-groups --bootstrap median --seed 3 --resamples 999 " + file)["bootstrap"];

  EXPECT_EQ(exact["resamples"], 3125);
  expectMatch(exact["estimate"], c.expected.at("theta"), c.tolerance, "estimate");
  expectMatch(exact["error"], c.expected.at("boot_se"), c.tolerance, "error");
  expectMatch(exact["z0"], c.expected.at("z0_half"), c.tolerance, "z0");
  expectMatch(exact["acceleration"], c.expected.at("a"), c.tolerance, "acceleration");
  for (const auto& [key, name] : std::vector<std::pair<const char*, const char*>>{
           {"percentile", "perc"}, {"basic", "basic"}, {"bca", "bca"}, {"bca_levels", "bca_levels"}}) {
    expectMatch(exact[key]["lower"], c.expected.at(name)[0], c.tolerance, key);
    expectMatch(exact[key]["upper"], c.expected.at(name)[1], c.tolerance, key);
  }
  EXPECT_EQ(median["groups"][0]["estimate"], 5.0);  // of 2, 3, 5, 8, 13
  EXPECT_EQ(median["seed"], 3);
}

TEST_F(ComparisonCommands, PairsOfThreeGroupsHaveTheRequestedAdjustment) {
  // Bonferroni: three pairs, so three times p, at most 1.
  std::string table = "subject,group,score\n";
  const ReferenceCase c = referenceCase("groups", "plantgrowth_three_groups_of_ten");
  std::size_t subject = 0;
  for (const char* group : {"ctrl", "trt1", "trt2"}) {
    for (const double score : numbers(c.input.at(group))) {
      addRow(table, {named("s", subject++), group, json(score).dump()});
    }
  }

  const json out = answer("compare-groups --adjust bonferroni " + write("plants.csv", table));

  for (const json& pair : out["student_t"]["pairs"]) {
    EXPECT_DOUBLE_EQ(pair["p_adjusted"].get<double>(), std::min(1.0, 3.0 * pair["p"].get<double>()));
  }
  expectMatch(out["bartlett"]["p"], c.expected.at("bartlett").at("p"), c.tolerance, "Bartlett");
  expectMatch(out["shapiro_wilk"]["statistic"], c.expected.at("shapiro_residuals").at("W"), 1e-6,
              "Shapiro-Wilk");
}

}  // namespace
}  // namespace torsio
