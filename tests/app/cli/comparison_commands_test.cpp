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
using test::numbers;
using test::ReferenceCase;
using test::referenceCase;
using ComparisonCommands = TableCommands;

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

// Sample sizes, standards and proficiency against the reference cases of tests/data/assessment.

using PlanningCommands = TableCommands;

TEST_F(PlanningCommands, PowerComputesTheThirdOfSizeEffectAndPower) {
  const ReferenceCase c = referenceCase("groups", "power");
  const auto expectAnswer = [&](const std::string& question, const char* key, const char* name) {
    expectMatch(answer("power " + question)[json::json_pointer(key)], c.expected.at(name), c.tolerance, name);
  };

  expectAnswer("--test t --n 10 --effect 0.8", "/power", "t_n10_d08");
  expectAnswer("--test t --effect 0.5 --power 0.8", "/n", "t_d05_80");
  expectAnswer("--test t --n 10 --power 0.8", "/effect/value", "t_n10_80_d");
  expectAnswer("--test paired-t --n 10 --power 0.8", "/effect/value", "paired_n10_80_d");
  expectAnswer("--test anova --n 10 --effect 0.4", "/power", "aov_k3_n10_f04");
  expectAnswer("--test anova --effect 0.25 --power 0.8", "/n", "aov_k3_f025_80");
  const json icc = answer("power --test icc --icc 0.7 --raters 3 --width 0.2");
  expectMatch(icc["targets"], c.expected.at("bonett_icc").at("rho07_k3_w02"), c.tolerance, "ICC");
  EXPECT_EQ(icc["targets_needed"], 68);  // 67.38 rounded up
}

TEST_F(PlanningCommands, PowerRepeatsItsInput) {
  const json paired = answer("power --test paired-t --effect 0.9960013714554439 --power 0.8");
  const json anova = answer("power --test anova --groups 4 --n 12 --power 0.9");
  const json again =
      answer("power --test anova --groups 4 --n 12 --effect " + anova["effect"]["value"].dump());
  const json covariate = answer("power --test t --effect 0.8 --power 0.8 --correlation 0.6");

  EXPECT_NEAR(paired["n"].get<double>(), 10.0, 1e-6);
  EXPECT_NEAR(again["power"].get<double>(), 0.9, 1e-9);
  // 1 - 0.6^2 = 0.64 of the size without a covariate
  EXPECT_NEAR(covariate["n_with_covariate"].get<double>(), 0.64 * covariate["n"].get<double>(), 1e-9);
  EXPECT_EQ(covariate["n_needed"], 26);
  EXPECT_EQ(answer("power --test t --effect 20 --power 0.5")["n_needed"], 2);
  expectRefused("power --test t --n 10", {"--effect"}, ErrorCode::kUsage);
  expectRefused("power --test icc --icc 0.7", {"--width"}, ErrorCode::kUsage);
  expectRefused("power --test t --n 10 --power 0.04", {"0.05"}, ErrorCode::kBadParameter);
}

TEST_F(PlanningCommands, StandardsFromContrastingGroupsCutBetweenTheMeans) {
  const ReferenceCase c = referenceCase("learning", "contrasting_groups");
  std::string table = "subject,group,score\n";
  for (std::size_t s = 0; s < c.input.at("score").size(); ++s) {
    addRow(table, {named("s", s), c.input.at("master")[s].get<int>() == 1 ? "master" : "novice",
                   c.input.at("score")[s].dump()});
  }

  const json standard =
      answer("standard-setting --method contrasting-groups " + write("groups.csv", table))["standard"];

  expectMatch(standard["cut"], c.expected.at("cut_normal_intersection"), c.tolerance, "cut");
  expectMatch(standard["other_crossing"], c.expected.at("roots")[0], c.tolerance, "other crossing");
  expectMatch(standard["false_pass"], c.expected.at("false_pos_normal"), c.tolerance, "false pass");
  expectMatch(standard["logistic"]["cut"], c.expected.at("cut_logistic50"), 1e-6, "logistic cut");
  expectRefused("standard-setting --method contrasting-groups " +
                    write("third.csv", "subject,group,score\na,novice,1\nb,expert,2\n"),
                {"third.csv, line 3", "\"expert\"", "novice or master"});
}

TEST_F(PlanningCommands, StandardsByAngoffAndProficiencyMatchTheirCases) {
  const ReferenceCase judges = referenceCase("learning", "angoff");
  std::string percent = "judge,item,percent\n";
  const json& rows = judges.input.at("judge_by_item_percent");
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (std::size_t i = 0; i < rows[j].size(); ++i) {
      addRow(percent, {named("j", j), named("i", i), rows[j][i].dump()});
    }
  }
  const ReferenceCase experts = referenceCase("learning", "proficiency_threshold");
  std::string times = "expert,value\n";
  const std::vector<double> seconds = numbers(experts.input.at("expert_times_s"));
  for (std::size_t e = 0; e < seconds.size(); ++e) {
    addRow(times, {named("e", e), json(seconds[e]).dump()});
  }

  const json angoff = answer("standard-setting --method angoff " + write("angoff.csv", percent))["standard"];
  const json proficiency =
      answer("standard-setting --method proficiency " + write("times.csv", times))["standard"];

  expectMatch(angoff["cut"], judges.expected.at("cut_raw"), judges.tolerance, "cut");
  expectMatch(angoff["error"], judges.expected.at("se_judges"), judges.tolerance, "error of judges");
  expectMatch(proficiency["one_sd"], experts.expected.at("mean_plus_sd"), experts.tolerance, "mean + SD");
  expectMatch(proficiency["tolerance_bound"], experts.expected.at("upper_tol"), experts.tolerance, "bound");
}

TEST_F(PlanningCommands, StandardsByBorderlineRegressionPredictTheBorderlineScore) {
  // Scores 10 + 5 x rating, one above and one below at the same rating: the line is unchanged, its cut at 2
  // is 20.
  const std::string file =
      write("global.csv", "subject,global,score\na,1,16\nb,1,14\nc,3,25\nd,3,25\ne,5,35\n");
  const std::string method = "standard-setting --method borderline-regression ";

  const json standard = answer(method + "--borderline 2 " + file)["standard"];

  EXPECT_NEAR(standard["slope"].get<double>(), 5.0, 1e-12);
  EXPECT_NEAR(standard["cut"].get<double>(), 20.0, 1e-12);
  expectRefused(method + file, {"--borderline"}, ErrorCode::kUsage);
  expectRefused(
      "standard-setting --method angoff " + write("hole.csv", "judge,item,percent\na,1,50\nb,2,50\n"),
      {"hole.csv", "\"a\"", "\"2\""});
  expectRefused("standard-setting --method angoff " + write("over.csv", "judge,item,percent\na,1,101\n"),
                {"over.csv, line 2", "101"});
  expectRefused("standard-setting --method proficiency " + write("again.csv", "expert,value\na,1\na,2\n"),
                {"again.csv, line 3", "line 2"});
}

TEST_F(PlanningCommands, LearningReportsTheAttemptOfProficiency) {
  // At most 40 s twice in a row: attempts 4 and 5; one more: attempt 7.
  std::string table = "subject,attempt,value\n";
  const std::vector<int> seconds = {60, 39, 55, 40, 38, 50, 36};
  for (std::size_t t = 0; t < seconds.size(); ++t) {
    addRow(table, {"P01", std::to_string(t + 1), std::to_string(seconds[t])});
  }
  const std::string command = "learning --threshold 40 " + write("times.csv", table);

  const json two = answer(command);
  const json further = answer(command + " --further 1");
  const json higher = answer(command + " --better higher --consecutive 3");

  EXPECT_EQ(two["subjects"][0]["proficient_at"], 5);
  EXPECT_EQ(further["subjects"][0]["proficient_at"], 7);
  EXPECT_TRUE(higher["subjects"][0]["proficient_at"].contains("undefined"));
  // Two in a row among seven: 1 - sum of C(8 - f, f) over f of 2^-7 with fair coins = 94 of 128.
  const json fair = answer(command + " --inadequate 0.5 --adequate 0.1")["subjects"][0];
  EXPECT_NEAR(fair["proficient_if_inadequate"].get<double>(), 94.0 / 128.0, 1e-15);
  EXPECT_GT(fair["proficient_if_adequate"].get<double>(), 0.99);
  std::string thousand = "subject,attempt,value\n";
  for (int t = 1; t <= 1000; ++t) {
    addRow(thousand, {"P01", std::to_string(t), "50"});
  }
  const json certain = answer("learning --threshold 40 " + write("thousand.csv", thousand))["subjects"][0];
  EXPECT_EQ(certain["proficient_if_inadequate"], 1.0);  // rounding must not exceed it
  EXPECT_LT(answer(command + " --further 1 --inadequate 0.5")["subjects"][0]["proficient_if_inadequate"]
                .get<double>(),
            94.0 / 128.0);
}

TEST_F(PlanningCommands, LearningAcceptsAnyCusumLimitAndReportsUnboundedRunLengths) {
  // Sums above the target grow by 0.5 at the second value and by 2999.5 at the third.
  const std::string file = write("sums.csv", "subject,attempt,value\na,1,10\na,2,11\na,3,3010\n");
  const std::string command = "learning --target 10 --sigma 1 " + file + " --cusum-limit ";

  const json usual = answer(command + "5")["subjects"][0]["cusum"];
  const json beyond = answer(command + "2500")["subjects"][0]["cusum"];
  const json never = answer(command + "3000.5")["subjects"][0]["cusum"];

  EXPECT_NEAR(usual["average_run_length"].get<double>(), 465.4, 0.1);  // Montgomery, k = 0.5, h = 5
  EXPECT_EQ(beyond["upper"], json({0.0, 0.5, 3000.0}));
  EXPECT_EQ(beyond["first_signal"], 3);
  EXPECT_EQ(beyond["average_run_length"]["undefined"], "it is longer than 1e12 values");
  EXPECT_TRUE(never["first_signal"].contains("undefined"));
  for (const char* none : {"0", "-1", "nan", "inf"}) {
    expectRefused(command + none, {"--cusum-limit"}, ErrorCode::kUsage);
  }
}

}  // namespace
}  // namespace torsio
