// SPDX-License-Identifier: GPL-3.0-or-later
// Paired scores, resampling and adjusted pairs against the reference cases of tests/data/assessment. torsio
// agreement against the reference cases of tests/data/assessment.

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
  const json certain =
      answer("learning --inadequate 0.2 --threshold 40 " + write("thousand.csv", thousand))["subjects"][0];
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

using AgreementCommands = TableCommands;

TEST_F(AgreementCommands, AgreementByRaschGivesAbilitiesSeveritiesAndThresholds) {
  const ReferenceCase c = referenceCase("rasch", "mfrm_jml_12x4");
  const std::string file = write("rasch.csv", ratings(c.input.at("ratings_0_4")));

  const json out = answer("agreement --method rasch --lowest 0 --highest 4 --ratings " + file);

  const json& rasch = out["rasch"];
  for (std::size_t n = 0; n < 12; ++n) {
    expectMatch(rasch["persons"][n]["ability"], c.expected.at("theta")[n], c.tolerance, "ability");
    expectMatch(rasch["persons"][n]["joint_error"], c.expected.at("joint_se")[n], c.tolerance, "joint error");
    expectMatch(rasch["persons"][n]["infit"], c.expected.at("infit_person")[n], c.tolerance, "infit");
    expectMatch(rasch["persons"][n]["fair_average"], c.expected.at("fair_average")[n], c.tolerance, "fair");
  }
  for (std::size_t r = 0; r < 4; ++r) {
    EXPECT_EQ(rasch["raters"][r]["rater"], named("r", r));
    expectMatch(rasch["raters"][r]["severity"], c.expected.at("severity")[r], c.tolerance, "severity");
    expectMatch(rasch["thresholds"][r], c.expected.at("tau")[r], c.tolerance, "threshold");
  }
  EXPECT_EQ(out["scale"], json({{"lowest", 0}, {"highest", 4}}));
}

TEST_F(AgreementCommands, AgreementByRaschNamesUnboundedRaters) {
  // Raters 1 and 2, and raters 3 and 4, bound each other; only one mark of each pair compares the two pairs.
  const std::string file =
      write("apart.csv",
            "target,rater,score\n"
            "a,r1,0\na,r2,1\nb,r1,1\nb,r2,0\nc,r3,0\nc,r4,1\nd,r3,1\nd,r4,0\ne,r1,0\ne,r3,1\n");

  const json out = answer("agreement --method rasch --ratings " + file);

  EXPECT_NE(out["rasch"]["undefined"].get<std::string>().find("bounds rater 3 and rater 4"),
            std::string::npos)
      << out;
}

TEST_F(AgreementCommands, AgreementByRaschRejectsScoresThatAreNoCategories) {
  const std::string file = write("half.csv", "target,rater,score\na,x,1\na,y,2.5\n");
  const std::string whole = write("whole.csv", "target,rater,score\na,x,1\na,y,2\n");

  expectRefused("agreement --method rasch --ratings " + file, {"2.5", "not a whole number"});
  expectRefused("agreement --method rasch --highest 1 --ratings " + whole, {"from 1.0 to 2.0", "--highest"});
}

TEST_F(AgreementCommands, AgreementByKappaGivesTheThreeWeightsAndCustomOnes) {
  const ReferenceCase c = referenceCase("agreement", "kappa_cohen_1968");
  std::string table = "target,rater,score\n";
  std::size_t target = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (int n = 0; n < c.input.at("table")[i][j].get<int>(); ++n, ++target) {
        addRow(table, {named("t", target), "first", std::to_string(i + 1)});
        addRow(table, {named("t", target), "second", std::to_string(j + 1)});
      }
    }
  }
  const std::string weights = write("weights.csv", "first,second,disagreement\n1,2,1\n1,3,3\n3,2,6\n");

  const json out = answer("agreement --method kappa --disagreement " + weights + " --ratings " +
                          write("kappa.csv", table));

  const json& pair = out["pairs"][0];
  EXPECT_EQ(pair["n"], 200);
  for (const auto& [key, name] :
       std::vector<std::pair<const char*, const char*>>{{"unweighted", "unweighted"},
                                                        {"linear", "linear"},
                                                        {"quadratic", "quadratic"},
                                                        {"own_weights", "custom"}}) {
    const json& expected = c.expected.at(name);
    expectMatch(pair[key]["kappa"], expected.at("kappa"), c.tolerance, key);
    expectMatch(pair[key]["observed"], expected.at("po"), c.tolerance, key);
    expectMatch(pair[key]["error"], expected.at("se"), c.tolerance, key);
    expectMatch(pair[key]["z"], expected.at("z"), c.tolerance, key);
  }
}

TEST_F(AgreementCommands, AgreementByKappaGivesFleissForManyRaters) {
  const ReferenceCase c = referenceCase("agreement", "fleiss_kappa_10x14");
  std::string table = "target,rater,score\n";
  const json& counts = c.input.at("counts_subject_by_category");
  for (std::size_t s = 0; s < counts.size(); ++s) {
    std::size_t rater = 0;
    for (std::size_t category = 0; category < counts[s].size(); ++category) {
      for (int n = 0; n < counts[s][category].get<int>(); ++n) {
        addRow(table, {named("t", s), named("r", rater++), std::to_string(category + 1)});
      }
    }
  }

  const json out = answer("agreement --method kappa --ratings " + write("fleiss.csv", table));

  expectMatch(out["fleiss"]["kappa"], c.expected.at("kappa"), c.tolerance, "kappa");
  expectMatch(out["fleiss"]["observed"], c.expected.at("Pbar"), c.tolerance, "observed");
  expectMatch(out["fleiss"]["z"], c.expected.at("z"), c.tolerance, "z");
  EXPECT_EQ(out["fleiss"]["by_category"].size(), 5U);
}

TEST_F(AgreementCommands, AgreementByKappaRejectsScoresOutsideTheCategories) {
  const std::string file = write("kappa.csv", "target,rater,score\na,x,1\na,y,2\n");
  const std::string half = write("half.csv", "first,second,disagreement\n1,2,1\n");
  const std::string twice = write("twice.csv", "first,second,disagreement\n1,2,1\n2,1,4\n");
  const std::string kappa = "agreement --method kappa --ratings " + file;

  expectRefused(kappa + " --categories 1,3", {"2.0", "--categories"});
  expectRefused(kappa + " --categories 1,2,1", {"1.0", "twice"}, ErrorCode::kBadParameter);
  expectRefused(kappa + " --categories 1,2,3 --disagreement " + half, {"half.csv", "1.0 and 3.0"});
  expectRefused(kappa + " --disagreement " + twice, {"twice.csv, line 3"});
  std::string table = "target,rater,score\n";
  for (int i = 0; i < 101; ++i) {
    table += "t" + std::to_string(i) + ",x," + std::to_string(i) + ".5\n";
  }
  expectRefused("agreement --method kappa --ratings " + write("scores.csv", table), {"101", "Collapse"});
}

TEST_F(AgreementCommands, AgreementByBlandAltmanGivesTheLimitsOfThePaper) {
  const ReferenceCase c = referenceCase("agreement", "bland_altman_1986");
  std::string table = "target,rater,score\n";
  for (const char* meter : {"wright", "mini"}) {
    const std::vector<double> flow = numbers(c.input.at(meter));
    for (std::size_t i = 0; i < flow.size(); ++i) {
      // The first by name is the first of the pair.
      addRow(table, {named("t", i), meter == std::string("wright") ? "large" : "mini", json(flow[i]).dump()});
    }
  }

  const json out = answer("agreement --method bland-altman --ratings " + write("flow.csv", table));

  const json& pair = out["pairs"][0];
  expectMatch(pair["mean_difference"], c.expected.at("mean"), c.tolerance, "mean");
  expectMatch(pair["sd"], c.expected.at("sd"), c.tolerance, "sd");
  expectMatch(pair["limits"]["lower"], c.expected.at("loa_196")[0], c.tolerance, "lower limit");
  expectMatch(pair["limits"]["upper"], c.expected.at("loa_196")[1], c.tolerance, "upper limit");
  expectMatch(pair["lower_limit_interval"]["lower"], c.expected.at("loa_lower_ci")[0], c.tolerance,
              "interval");
  expectMatch(pair["limit_error_exact"], c.expected.at("loa_se_exact_form"), c.tolerance, "exact error");
  EXPECT_TRUE(out["against_panel"].contains("undefined")) << out["against_panel"];
}

TEST_F(AgreementCommands, AgreementByBlandAltmanComparesEachRaterWithTheOthers) {
  // Rater z against the mean of x and y: differences 2, 1, 3 have mean 2 and standard deviation 1.
  const std::string file = write(
      "panel.csv", "target,rater,score\na,x,1\na,y,3\na,z,4\nb,x,2\nb,y,2\nb,z,3\nc,x,3\nc,y,5\nc,z,7\n");

  const json out = answer("agreement --method bland-altman --ratings " + file);

  ASSERT_EQ(out["against_panel"].size(), 3U);
  EXPECT_EQ(out["against_panel"][2]["rater"], "z");
  EXPECT_EQ(out["against_panel"][2]["mean_difference"], 2.0);
  EXPECT_EQ(out["against_panel"][2]["sd"], 1.0);
  EXPECT_EQ(out["pairs"].size(), 3U);
}

TEST_F(AgreementCommands, AgreementByIccGivesTheMeanSquares) {
  const ReferenceCase c = referenceCase("agreement", "icc_shrout_fleiss_1979");
  const std::string file = write("icc.csv", ratings(c.input.at("ratings_target_by_judge")));

  const json out = answer("agreement --method icc --ratings " + file);

  expectMatch(out["mean_squares"]["targets"], c.expected.at("BMS"), c.tolerance, "BMS");
  expectMatch(out["mean_squares"]["error"], c.expected.at("EMS"), c.tolerance, "EMS");
  expectMatch(out["tests"]["two_way"]["p"], c.expected.at("p_twoway"), c.tolerance, "p");
  expectMatch(out["variances"]["raters"], c.expected.at("var_rater"), c.tolerance, "rater variance");
  expectMatch(out["sem"]["agreement"], c.expected.at("SEM_agreement"), c.tolerance, "SEM");
}

TEST_F(AgreementCommands, AgreementByIccWithinEachGroup) {
  const std::vector<std::string> first = {"a,x,1,one", "a,y,2,one", "b,x,3,one",
                                          "b,y,3,one", "c,x,4,one", "c,y,6,one"};
  const std::vector<std::string> second = {"d,x,7,two", "d,y,9,two", "e,x,8,two",
                                           "e,y,8,two", "f,x,9,two", "f,y,"};
  const auto table = [&](const std::vector<std::vector<std::string>>& parts) {
    std::string text = "target,rater,score,group\n";
    for (const std::vector<std::string>& part : parts) {
      for (const std::string& line : part) {
        text += line + (line.back() == ',' ? ",two\n" : "\n");
      }
    }
    return text;
  };
  const std::string command = "agreement --method icc --ratings ";

  const json out = answer(command + write("groups.csv", table({first, second})));

  ASSERT_EQ(out["within_groups"].size(), 2U);
  EXPECT_EQ(out["within_groups"][0]["group"], "one");
  const json alone = answer(command + write("one.csv", table({first})));
  EXPECT_EQ(out["within_groups"][0]["icc"], alone["icc"]);
  EXPECT_EQ(out["within_groups"][0]["sem"], alone["sem"]);
  EXPECT_EQ(out["within_groups"][1]["left_out_targets"], json::array({"f"}));
  EXPECT_EQ(out["within_groups"][1]["targets"], 2);
  expectRefused(command + write("both.csv", "target,rater,score,group\na,x,1,one\na,y,2,two\n"),
                {"line 3", "\"a\"", "one group"});
}

TEST_F(AgreementCommands, AgreementByKrippendorffIsReproducibleForASeed) {
  const ReferenceCase c = referenceCase("rasch", "mfrm_jml_12x4");
  const std::string file = write("alpha.csv", ratings(c.input.at("ratings_0_4")));
  const std::string command = "agreement --method krippendorff --resamples 199 --ratings " + file;

  const json one = answer(command + " --seed 7");
  const json same = answer(command + " --seed 7");
  const json other = answer(command + " --seed 8");

  for (const char* metric : {"nominal", "ordinal", "interval", "ratio"}) {
    const json& alpha = one["krippendorff"][metric];
    EXPECT_LT(alpha["bootstrap"]["lower"], alpha["alpha"]) << metric;
    EXPECT_GT(alpha["bootstrap"]["upper"], alpha["alpha"]) << metric;
    EXPECT_EQ(alpha["bootstrap"]["resamples"], 199);
  }
  EXPECT_EQ(one, same);
  EXPECT_NE(one["krippendorff"], other["krippendorff"]);
}

TEST_F(AgreementCommands, GeneralizabilityOfOccasionsPlansRatersAndOccasions) {
  const ReferenceCase c = referenceCase("generalizability", "g_brennan_synth3_p_x_i_x_o");
  std::string table = "target,rater,occasion,score\n";
  const json& data = c.input.at("o_i_p");
  for (std::size_t o = 0; o < data.size(); ++o) {
    for (std::size_t i = 0; i < data[o].size(); ++i) {
      for (std::size_t p = 0; p < data[o][i].size(); ++p) {
        addRow(table, {named("t", p), named("r", i), named("o", o), data[o][i][p].dump()});
      }
    }
  }

  const json out = answer("agreement --method generalizability --raters 10,1 --occasions 3,1 --ratings " +
                          write("crossed.csv", table));

  const std::vector<const char*> effects = {"p", "i", "o", "pi", "po", "io", "pio"};
  for (std::size_t e = 0; e < effects.size(); ++e) {
    expectMatch(out["components"][e]["variance"], c.expected.at("var").at(effects[e]), c.tolerance,
                effects[e]);
  }
  ASSERT_EQ(out["plans"].size(), 4U);
  EXPECT_EQ(out["plans"][0]["raters"], 10.0);
  EXPECT_EQ(out["plans"][0]["occasions"], 3.0);
  for (const auto& [plan, key] :
       std::vector<std::pair<std::size_t, const char*>>{{0, "D_10_3"}, {2, "D_10_1"}, {3, "D_1_1"}}) {
    const json& expected = c.expected.at(key);
    expectMatch(out["plans"][plan]["generalizability"], expected.at("Erho2"), c.tolerance, key);
    expectMatch(out["plans"][plan]["dependability"], expected.at("Phi"), c.tolerance, key);
  }
}

TEST_F(AgreementCommands, GeneralizabilityOfTasksNestsTheRaters) {
  const ReferenceCase c = referenceCase("generalizability", "g_brennan_synth4_p_x_r_in_t");
  std::string table = "target,rater,task,score\n";
  const json& data = c.input.at("persons_by_(task*4+rater)");
  for (std::size_t p = 0; p < data.size(); ++p) {
    for (std::size_t j = 0; j < data[p].size(); ++j) {
      addRow(table, {named("t", p), named("r", j), named("task", j / 4), data[p][j].dump()});
    }
  }

  const json out = answer("agreement --method generalizability --ratings " + write("nested.csv", table));

  const std::vector<const char*> effects = {"p", "t", "rt", "pt", "prt"};
  for (std::size_t e = 0; e < effects.size(); ++e) {
    expectMatch(out["components"][e]["variance"], c.expected.at("var").at(effects[e]), c.tolerance,
                effects[e]);
  }
  EXPECT_EQ(out["plans"][0]["raters"], 4.0);
  expectMatch(out["plans"][0]["generalizability"], c.expected.at("Erho2"), c.tolerance, "E rho^2");
  expectMatch(out["plans"][0]["absolute_error"], c.expected.at("abs_err"), c.tolerance, "absolute error");
}

TEST_F(AgreementCommands, GeneralizabilityOfRatersAloneAndItsRefusals) {
  // Person means 1.5, 3, 5 about 19/6: 2 x 6.1667 / 2; rater means 8/3, 11/3: 3 x 0.5; residual 1 / 2.
  const std::string plain =
      write("plain.csv", "target,rater,score\na,x,1\na,y,2\nb,x,3\nb,y,3\nc,x,4\nc,y,6\n");
  const std::string hole = write("hole.csv", "target,rater,score\na,x,1\na,y,2\nb,x,3\nb,y,\n");
  const std::string both = write("both.csv", "target,rater,occasion,task,score\na,x,1,1,2\n");
  const std::string method = "agreement --method generalizability --ratings ";

  const json out = answer(method + plain);

  EXPECT_NEAR(out["components"][0]["mean_square"].get<double>(), 6.166666666666667, 1e-12);
  EXPECT_NEAR(out["components"][1]["mean_square"].get<double>(), 1.5, 1e-12);
  EXPECT_NEAR(out["components"][2]["mean_square"].get<double>(), 0.5, 1e-12);
  EXPECT_NEAR(out["components"][0]["variance"].get<double>(), (6.166666666666667 - 0.5) / 2.0, 1e-12);
  const json holed = answer(method + hole);
  EXPECT_EQ(holed["left_out_targets"], json::array({"b"}));
  EXPECT_TRUE(holed["components"].contains("undefined"));  // only one target remains
  const std::string more =
      write("more.csv", "target,rater,score\na,x,1\na,y,2\nb,x,3\nb,y,3\nd,x,5\nc,x,4\nc,y,6\n");
  EXPECT_EQ(answer(method + more)["components"], out["components"]);
  expectRefused(method + both, {"both.csv", "occasions and tasks"});
  expectRefused(method + plain + " --tasks 2", {"\"task\"", "--tasks"}, ErrorCode::kBadParameter);
}

TEST_F(AgreementCommands, OptionsOfAnotherMethodAreRejected) {
  const std::string file = write("two.csv", "target,rater,score\na,x,1\na,y,2\n");

  expectRefused("agreement --lowest 0 --ratings " + file, {"--lowest", "--method rasch"}, ErrorCode::kUsage);
  expectRefused("agreement --method kappa --seed 2 --ratings " + file, {"--seed"}, ErrorCode::kUsage);
  expectRefused("agreement --method cohen --ratings " + file, {"cohen"}, ErrorCode::kUsage);
  expectRefused("compare-groups --resamples 200 " + file, {"--resamples", "--bootstrap"}, ErrorCode::kUsage);
  expectRefused("compare-groups --paired t --adjust holm " + file, {"--adjust"}, ErrorCode::kUsage);
  expectRefused("power --test t --n 10 --effect 1 --groups 3", {"--groups", "anova"}, ErrorCode::kUsage);
  expectRefused("standard-setting --method angoff --log " + file, {"--log", "proficiency"},
                ErrorCode::kUsage);
  expectRefused("learning --further 2 " + file, {"--further", "--threshold"}, ErrorCode::kUsage);
}

}  // namespace

}  // namespace torsio
