// SPDX-License-Identifier: GPL-3.0-or-later
// Assessment commands: known numbers in, the documented JSON out; invalid tables are rejected with file,
// line, value and rule. compare-groups on marks by rater: missing marks, covariates, margins, permutations
// beyond counting.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/base/assets.h"
#include "app/services/recording/recorded_run.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/record/trial_file.h"
#include "tests/app/cli/table_commands.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

using AssessmentCommands = TableCommands;

constexpr double kPublished = 1e-8;  // the sources below print eight or nine digits

/// 20 interns, 10 deputy chiefs and 10 chiefs, who give 7, 8 and 9 for everything.
std::string paperTable() {
  std::string text = "\xEF\xBB\xBFscore,model,class,rater,index\r\n";
  const auto add = [&](const std::string& raterClass, int count, const std::string& score) {
    for (int r = 0; r < count; ++r) {
      for (int j = 1; j <= 9; ++j) {
        text.append(score).append(",PM,").append(raterClass).append(",");
        text.append(raterClass).append(std::to_string(r)).append(",");
        text.append(std::to_string(j)).append("\r\n");
      }
    }
  };
  add("A", 20, "7");
  add("B", 10, "8");
  add("C", 10, "9");
  return text;
}

TEST_F(AssessmentCommands, EvaluateGivesAnIntervalOverResampledPanels) {
  // One index, one class: 6 and 8 give 6, 7 or 8 in a resampled panel (1/4, 1/2, 1/4).
  const std::string file = write("two.csv", "index,rater,class,model,score\n1,a,A,PM,6\n1,b,A,PM,8\n");
  const std::string call = "evaluate --weights 1 --class-weights 1 --ratings " + file;

  const json model = answer(call + " --resamples 2000 --seed 5")["models"][0];

  EXPECT_EQ(model["N"], 7.0);
  EXPECT_EQ(model["N_interval"], json({6.0, 8.0}));
  EXPECT_FALSE(answer(call)["models"][0].contains("N_interval"));
}

/// One name in two spellings would count as two people; both lines are named.
TEST_F(AssessmentCommands, NamesThatLookAlikeAreRefusedByEveryReader) {
  const std::vector<std::string> spellings{
      "Jos\xC3\xA9\xC2\xA0"
      "A1",
      "Jose\xCC\x81 A1", "jos\xC3\xA9 a1", "Jos\xC3\xA9 \xEF\xBC\xA1\xEF\xBC\x91", "JOS\xC3\x89 A1"};
  const std::string name = "Jos\xC3\xA9 A1";
  for (const std::string& other : spellings) {
    const auto two = [&](const std::string& header, const std::string& before, const std::string& after) {
      return write("two.csv",
                   header + "\n" + before + name + after + "\nx,y,3\n" + before + other + after + "\n");
    };
    const std::vector<std::string> both{"looks like", "line 2", "line 4"};
    expectRefused("compare-groups " + two("subject,group,score", "", ",g,1"), both);
    expectRefused("compare-groups " + two("score,subject,group", "1,", ",g"), both);
    expectRefused("agreement --ratings " + two("target,rater,score", "", ",r,1"), both);
    expectRefused("learning " + two("subject,attempt,value", "", ",1,1"), both);
  }
  expectRefused(
      "compare-groups " + write("groups.csv", "subject,group,score\na,G1,1\nb,g1,2\nc,\xEF\xBC\xA7\x31,3\n"),
      {"group \"g1\" looks like \"G1\"", "line 2", "line 3"});
  expectRefused(
      "agreement --ratings " + write("zero.csv", "target,rater,score\nT1,A,1\nT1,A\xE2\x80\x8B,2\n"),
      {"a rater contains the invisible character U+200B", "line 3"});
  expectRefused("agreement --ratings " + write("bell.csv", "target,rater,score\nT1,A,1\nT\x07,A,2\n"),
                {"a target contains the invisible character U+0007", "line 3"});
}

TEST_F(AssessmentCommands, ANumberThatASpreadsheetShortenedIsTold) {
  const std::string file = write("excel.csv", "subject,group,score\n1E+05,a,1\nS2,a,2\nS3,b,3\nS4,b,5\n");
  const ProgramRun run = runTorsio("compare-groups " + file, folder_);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("line 2: subject \"1E+05\" looks like a number"), std::string::npos) << run.err;
}

TEST_F(AssessmentCommands, EvaluateReadsAnyColumnOrderAndReproducesThePaper) {
  // Eq. 25: 0.2 x 7 + 0.3 x 8 + 0.5 x 9 = 8.3; plain mean (140 + 80 + 90) / 40 = 7.75;
  // Eq. 26: (20 x 1.69 + 10 x 0.09 + 10 x 0.49) / 40 = 0.99.
  const json model = answer("evaluate --ratings " + write("paper.csv", paperTable()))["models"][0];
  EXPECT_EQ(model["model"], "PM");
  EXPECT_EQ(model["N"], 8.3);
  ASSERT_EQ(model["indices"].size(), 9U);
  for (const json& index : model["indices"]) {
    EXPECT_EQ(index["M"], 8.3);
    EXPECT_EQ(index["s2"], 0.99);
    EXPECT_EQ(index["n"], 40);
    EXPECT_EQ(index["plain_mean"], 7.75);
    EXPECT_EQ(index["se"], 0.0);
  }
  EXPECT_EQ(model["indices"][8]["index"], 9);
  EXPECT_EQ(model["composites"].size(), 40U);
  EXPECT_TRUE(model["flags"].empty());
}

const char* const kFiveRaters =
    "index,rater,class,model,score\n1,a1,A,m,6\n1,a2,A,m,8\n1,b1,B,m,7\n1,b2,B,m,9\n";

TEST_F(AssessmentCommands, EvaluateSupportsOtherInstrumentsAndReportsUndefinedValues) {
  // A = (6, 8), B = (7, 9), C = (9): M = 83/10, s2 = 161/100, sample variance 1.70.
  const std::string file = write("five.csv", std::string(kFiveRaters) + "1,c1,C,m,9\n");
  const ProgramRun run = runTorsio("evaluate --weights 1 --ratings " + file, folder_);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("\"s2\": 1.6100000000000001,"), std::string::npos) << "17 significant digits";
  const json index = json::parse(run.out)["models"][0]["indices"][0];
  EXPECT_EQ(index["M"], 8.3);
  EXPECT_EQ(index["s2"], 1.61);
  EXPECT_EQ(index["sample_variance"], 1.7);
  EXPECT_EQ(index["population_variance"], 1.36);
  EXPECT_TRUE(index["se"].contains("undefined"));
}

TEST_F(AssessmentCommands, EvaluateRejectsAnEmptyClassUnlessRenormalised) {
  // Without class C: weights 0.4 / 0.6, M = 38/5, s2 = 63/50.
  const std::string file = write("four.csv", kFiveRaters);
  expectRefused("evaluate --weights 1 --ratings " + file, {"four.csv", "class C"});
  const json model = answer("evaluate --weights 1 --policy renormalise --ratings " + file)["models"][0];
  EXPECT_EQ(model["indices"][0]["M"], 7.6);
  EXPECT_EQ(model["indices"][0]["s2"], 1.26);
  EXPECT_EQ(model["flags"], json::array({"few raters", "renormalised"}));
}

TEST_F(AssessmentCommands, EvaluateNamesTheLineOfAClassWithoutScores) {
  const std::string file = write("empty.csv", std::string(kFiveRaters) + "1,c1,C,m,\n1,c2,C,m,\n");
  const std::string call = "evaluate --weights 1 --ratings " + file;
  expectRefused(call, {"empty.csv, line 6", "class C", "renormalise"});
  expectRefused(call + " --policy list-wise", {"empty.csv, line 6", "class C"});
  expectRefused(call + " --policy refuse", {"empty.csv, line 6", "c1"});
  EXPECT_EQ(answer(call + " --policy renormalise")["models"][0]["indices"][0]["M"], 7.6);
  // A class of weight zero may be empty.
  expectRefused("evaluate --weights 1 --class-weights 0.4,0,0.6 --ratings " + file, {"line 6"});
  answer("evaluate --weights 1 --class-weights 0.4,0.6,0 --ratings " + file);
}

TEST_F(AssessmentCommands, EvaluateDistinguishesMissingMarksFromZero) {
  const std::string file = write("hole.csv", std::string(kFiveRaters) + "1,c1,C,m,9\n1,c2,C,m,\n");
  expectRefused("evaluate --weights 1 --policy refuse --ratings " + file, {"hole.csv, line 7", "c2"});
  const json model = answer("evaluate --weights 1 --ratings " + file)["models"][0];
  EXPECT_EQ(model["indices"][0]["M"], 8.3);
  EXPECT_EQ(model["indices"][0]["n"], 5);
  EXPECT_EQ(model["flags"], json::array({"available-case"}));
  EXPECT_TRUE(model["composites"].back()["score"].contains("undefined"));
}

TEST_F(AssessmentCommands, EvaluateRejectsInvalidMarksWithLineValueAndRule) {
  const auto refused = [&](const std::string& row, const std::vector<std::string>& mentions) {
    const std::string file = write("bad.csv", std::string(kFiveRaters) + row + "\n");
    std::vector<std::string> all = mentions;
    all.push_back("bad.csv, line 6");
    expectRefused("evaluate --weights 1 --ratings " + file, all);
  };
  refused("1,c1,C,m,11", {"11", "outside the scale"});
  refused("1,c1,C,m,-1", {"-1", "outside the scale"});
  refused("1,c1,C,m,nan", {"nan", "not a finite number"});
  refused("1,c1,C,m,inf", {"inf", "not a finite number"});
  refused("1,c1,C,m,good", {"good", "not a number"});
  refused("1,c1,C,m,\"8,5\"", {"8,5", "decimal comma"});
  refused("1,c1,C,m,8,5", {"6 values", "8,5", "decimal comma"});
  refused("1,c1,C,m,8.25", {"8.25", "between two steps"});
  refused("1,a1,A,m,6", {"a1", "second time", "line 2"});
  refused("1,a1,B,n,6", {"a1", "line 2", "one class"});
  refused("1,d1,D,m,6", {"\"D\"", "A, B, C"});
  refused("2,c1,C,m,6", {"\"2\"", "1 to 1"});
  refused("1,,C,m,6", {"rater", "empty"});
  refused("1,c1,C,m,\"6", {"quote"});
}

TEST_F(AssessmentCommands, TablesWithAnInvalidHeaderAreRejected) {
  const auto refused = [&](const std::string& text, const std::string& mention) {
    expectRefused("agreement --ratings " + write("table.csv", text), {"table.csv", mention});
  };
  refused("", "empty");
  refused("target,rater,score\n", "no rows");
  refused("target,rater\nt,r\n", "\"score\"");
  refused("t1,r1,5\nt2,r1,6\n", "\"target\"");
  refused("target;rater;score\nt1;r1;5\n", "commas");
  refused("target,rater,score,score\nt1,r1,5,5\n", "twice");
  refused("target,rater,score\nt1,r\xFF,5\n", "UTF-8");
  refused(std::string("t\0a", 3), "UTF-8");
}

std::string ratingTable(const std::vector<std::vector<int>>& targets) {
  std::string text = "target,rater,score\n";
  for (std::size_t t = 0; t < targets.size(); ++t) {
    for (std::size_t r = 0; r < targets[t].size(); ++r) {
      if (targets[t][r] != 0) {
        text.append("t")
            .append(std::to_string(t))
            .append(",r")
            .append(std::to_string(r))
            .append(",")
            .append(std::to_string(targets[t][r]) + "\n");
      }
    }
  }
  return text;
}

TEST_F(AssessmentCommands, AgreementGivesTheTableOfShroutAndFleiss) {
  // Shrout and Fleiss (1979), table 2; digits beyond the published ones from R.
  const std::string file = write(
      "sf.csv",
      ratingTable({{9, 2, 5, 8}, {6, 1, 3, 2}, {8, 4, 6, 8}, {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}}));
  const json out = answer("agreement --ratings " + file);
  const auto expectForm = [&](const char* name, double estimate, double lower, double upper) {
    EXPECT_NEAR(out["icc"][name]["estimate"].get<double>(), estimate, kPublished) << name;
    EXPECT_NEAR(out["icc"][name]["lower"].get<double>(), lower, kPublished) << name;
    EXPECT_NEAR(out["icc"][name]["upper"].get<double>(), upper, kPublished) << name;
  };
  expectForm("ICC(1,1)", 0.165741768, -0.132932325, 0.722560062);
  expectForm("ICC(2,1)", 0.289763780, 0.018786513, 0.761084370);
  expectForm("ICC(3,1)", 0.714840715, 0.342464765, 0.945858260);
  expectForm("ICC(1,k)", 0.442797134, -0.884442155, 0.912415420);
  expectForm("ICC(2,k)", 0.620050548, 0.071136815, 0.927232040);
  expectForm("ICC(3,k)", 0.909315542, 0.675674714, 0.985891678);
  EXPECT_NEAR(out["cronbach"]["alpha"].get<double>(), 0.909315542, kPublished);
}

TEST_F(AssessmentCommands, AgreementWithGapsUsesTheCompleteTargetsAndNamesTheOthers) {
  // Krippendorff's table of four observers and twelve units; 0 stands for a missing value.
  const std::vector<std::vector<int>> coders = {{1, 2, 3, 3, 2, 1, 4, 1, 2, 0, 0, 0},
                                                {1, 2, 3, 3, 2, 2, 4, 1, 2, 5, 0, 3},
                                                {0, 3, 3, 3, 2, 3, 4, 2, 2, 5, 1, 0},
                                                {1, 2, 3, 3, 2, 4, 4, 1, 2, 5, 1, 0}};
  std::vector<std::vector<int>> units(12, std::vector<int>(4));
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t u = 0; u < 12; ++u) {
      units[u][c] = coders[c][u];
    }
  }
  const json out = answer("agreement --ratings " + write("holes.csv", ratingTable(units)));
  EXPECT_NEAR(out["krippendorff"]["nominal"].get<double>(), 0.743421053, kPublished);
  EXPECT_NEAR(out["krippendorff"]["ordinal"].get<double>(), 0.815387504, kPublished);
  EXPECT_NEAR(out["krippendorff"]["interval"].get<double>(), 0.849107143, kPublished);
  EXPECT_NEAR(out["krippendorff"]["ratio"].get<double>(), 0.797402775, kPublished);
  EXPECT_EQ(out["left_out_targets"], json::array({"t0", "t9", "t10", "t11"}));
  std::vector<std::vector<int>> complete(units.begin() + 1, units.begin() + 9);
  const json whole = answer("agreement --ratings " + write("complete.csv", ratingTable(complete)));
  EXPECT_EQ(out["icc"], whole["icc"]);
  EXPECT_EQ(out["kendall_w"], whole["kendall_w"]);
  EXPECT_EQ(out["cronbach"], whole["cronbach"]);
  EXPECT_TRUE(whole["left_out_targets"].empty());
}

TEST_F(AssessmentCommands, AgreementOfOneRaterOrWithoutVariationIsUndefined) {
  for (const json& out :
       {answer("agreement --ratings " + write("one.csv", ratingTable({{3}, {4}, {5}}))),
        answer("agreement --ratings " + write("same.csv", ratingTable({{5, 5}, {5, 5}, {5, 5}})))}) {
    EXPECT_TRUE(out["icc"]["ICC(1,1)"].contains("undefined")) << out;
    EXPECT_TRUE(out["krippendorff"]["interval"].contains("undefined")) << out;
    EXPECT_TRUE(out["kendall_w"].contains("undefined")) << out;
    EXPECT_TRUE(out["cronbach"].contains("undefined")) << out;
  }
}

const std::vector<std::pair<std::string, std::vector<std::string>>> kPlantGrowth = {
    {"ctrl", {"4.17", "5.58", "5.18", "6.11", "4.50", "4.61", "5.17", "4.53", "5.33", "5.14"}},
    {"trt1", {"4.81", "4.17", "4.41", "3.59", "5.87", "3.83", "6.03", "4.89", "4.32", "4.69"}},
    {"trt2", {"6.31", "5.12", "5.54", "5.50", "5.37", "5.29", "4.92", "6.15", "5.80", "5.26"}}};

std::string groupTable() {
  std::string text = "subject,group,score\n";
  for (const auto& [group, values] : kPlantGrowth) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      text.append(group + std::to_string(i)).append(",").append(group).append(",").append(values[i] + "\n");
    }
  }
  return text;
}

TEST_F(AssessmentCommands, CompareGroupsGivesTheTestsOfPlantGrowth) {
  // R's PlantGrowth: aov, oneway.test, kruskal.test, TukeyHSD, t.test, wilcox.test.
  const json out = answer("compare-groups " + write("plants.csv", groupTable()));
  EXPECT_NEAR(out["anova"]["statistic"].get<double>(), 4.84608786, kPublished);
  EXPECT_NEAR(out["anova"]["p"].get<double>(), 0.0159099583, kPublished);
  EXPECT_EQ(out["anova"]["df"], json::array({2.0, 27.0}));
  EXPECT_NEAR(out["anova"]["effect_size"]["value"].get<double>(), 0.204078846, kPublished);
  EXPECT_NEAR(out["welch_anova"]["statistic"].get<double>(), 5.18097241, kPublished);
  EXPECT_NEAR(out["kruskal_wallis"]["statistic"].get<double>(), 7.98822875, kPublished);
  EXPECT_NEAR(out["kruskal_wallis"]["effect_size"]["value"].get<double>(), 0.275456164, kPublished);
  EXPECT_NEAR(out["kruskal_wallis"]["dunn"][2]["p_holm"].get<double>(), 0.015000871, kPublished);
  EXPECT_NEAR(out["tukey"]["pairs"][2]["p"].get<double>(), 0.012006424, 1e-7);
  EXPECT_NEAR(out["games_howell"]["pairs"][1]["p"].get<double>(), 0.112889177, 1e-7);
  const json& welch = out["welch_t"]["pairs"][1];
  EXPECT_EQ(welch["groups"], json::array({"ctrl", "trt2"}));
  EXPECT_NEAR(welch["statistic"].get<double>(), -2.13402045, kPublished);
  EXPECT_NEAR(welch["df"].get<double>(), 16.7857645, 1e-7);
  EXPECT_NEAR(welch["effect_size"]["value"].get<double>(), -0.91394228, kPublished);
  EXPECT_NEAR(welch["effect_size"]["lower"].get<double>(), -1.7929085, 1e-7);
  EXPECT_NEAR(out["mann_whitney"]["pairs"][0]["p"].get<double>(), 0.196756804, kPublished);
  EXPECT_EQ(out["permutation"]["pairs"][2]["count"], 1592);
  EXPECT_FALSE(out.contains("ancova"));
}

TEST_F(AssessmentCommands, CompareGroupsAddsAncovaAndMixedAnovaWithOccasions) {
  std::string text = "subject,group,occasion,score\n";
  for (int s = 0; s < 6; ++s) {
    std::string who = "s";
    who.append(std::to_string(s)).append(s < 3 ? ",one," : ",two,");
    text += who + "before," + std::to_string(3 + s % 3) + "\n";
    text += who + "after," + std::to_string(5 + (2 * s + s % 2) % 5) + "\n";
  }
  const json out = answer("compare-groups " + write("training.csv", text));
  EXPECT_EQ(out["occasion"], "after");
  EXPECT_TRUE(out["ancova"].contains("p")) << out["ancova"];
  EXPECT_EQ(out["ancova"]["df"], json::array({1.0, 3.0}));  // six trainees, two groups, one slope
  EXPECT_EQ(out["mixed_anova"]["interaction"]["df"], json::array({1.0, 4.0}));
  EXPECT_TRUE(out["welch_t"].contains("statistic"));
  EXPECT_TRUE(out["hedges_g"].contains("value"));
}

TEST_F(AssessmentCommands, CompareGroupsRejectsDuplicateScoresAndReportsASingleGroup) {
  expectRefused("compare-groups " + write("two.csv", "subject,group,score\na,x,1\nb,x,2\na,x,3\n"),
                {"two.csv, line 4", "\"a\"", "line 2"});
  expectRefused("compare-groups " + write("moved.csv", "subject,group,occasion,score\na,x,1,1\na,y,2,2\n"),
                {"moved.csv, line 3", "one group"});
  const json out = answer("compare-groups " + write("lone.csv", "subject,group,score\na,x,1\nb,x,2\n"));
  for (const char* name : {"welch_t", "anova", "welch_anova", "mann_whitney", "kruskal_wallis", "tukey"}) {
    EXPECT_TRUE(out[name].contains("undefined")) << name;
  }
}

TEST_F(AssessmentCommands, LearningRecoversTheCurveOfTheValues) {
  // Exact values of 20 + 40 exp(-0.25 (t - 1)).
  std::string text = "attempt,subject,value\n";
  for (int t = 1; t <= 12; ++t) {
    text += std::to_string(t) + ",P01," + std::to_string(20.0 + 40.0 * std::exp(-0.25 * (t - 1))) + "\n";
  }
  const json subject = answer("learning " + write("curve.csv", text))["subjects"][0];
  constexpr double kSixDecimals = 1e-4;  // the values have six decimals
  EXPECT_NEAR(subject["exponential"]["asymptote"].get<double>(), 20.0, kSixDecimals);
  EXPECT_NEAR(subject["exponential"]["gain"].get<double>(), 40.0, kSixDecimals);
  EXPECT_NEAR(subject["exponential"]["rate"].get<double>(), 0.25, kSixDecimals);
  EXPECT_EQ(subject["exponential"]["band"].size(), 12U);
  const json few = answer("learning " + write("few.csv", "subject,attempt,value\na,1,5\na,2,4\n"));
  EXPECT_TRUE(few["subjects"][0]["power"].contains("undefined"));
}

TEST_F(AssessmentCommands, LearningOfPassAndFailComputesCusums) {
  // Biau and Porcher's weights for 0.1 and 0.2: +ln(0.9/0.8) and -ln(0.2/0.1).
  std::string text = "subject,attempt,value\n";
  for (int t = 1; t <= 40; ++t) {
    text.append("P01,").append(std::to_string(t)).append(t == 3 ? ",fail\n" : ",pass\n");
  }
  const std::string file = write("outcomes.csv", text);
  const json out = answer("learning --adequate 0.1 --inadequate 0.2 --false-pass 0.1 --limit 1.25 " + file);
  EXPECT_EQ(out["kind"], "pass/fail");
  const json& lc = out["subjects"][0]["lc_cusum"];
  EXPECT_NEAR(lc["success_weight"].get<double>(), 0.117783036, kPublished);
  EXPECT_NEAR(lc["failure_weight"].get<double>(), -0.693147181, kPublished);
  EXPECT_EQ(lc["competent_at"], 14);  // back at 0 after the failure, then 11 x 0.1178 > 1.25
  EXPECT_NEAR(out["subjects"][0]["cusum"]["h0"].get<double>(), 2.709511291, kPublished);
  const json chosen = answer("learning " + file)["design"];
  EXPECT_TRUE(chosen["limit_chosen"].get<bool>());
  // The same numbers as a competence design.
  const json plan = answer("competence plan");
  EXPECT_EQ(chosen["adequate"], plan["adequate"]);
  EXPECT_EQ(chosen["inadequate"], plan["inadequate"]);
  EXPECT_EQ(chosen["session_correlation"], plan["session_correlation"]);
  EXPECT_EQ(chosen["lag_correlation"], plan["lag_correlation"]);
  EXPECT_LE(chosen["pass_if_inadequate"].get<double>(), 0.025);
}

TEST_F(AssessmentCommands, LearningRejectsGapsDuplicatesAndMixtures) {
  const std::string header = "subject,attempt,value\n";
  expectRefused("learning " + write("gap.csv", header + "a,1,pass\na,3,fail\n"), {"line 3", "no attempt 2"});
  expectRefused("learning " + write("two.csv", header + "a,1,5\na,1,6\n"), {"line 3", "line 2"});
  expectRefused("learning " + write("mix.csv", header + "a,1,pass\na,2,6\n"), {"line 3", "\"6\""});
  expectRefused("learning " + write("zero.csv", header + "a,0,6\n"), {"line 2", "whole number"});
  expectRefused("learning " + write("word.csv", header + "a,1,6\na,2,x\n"), {"line 3", "\"x\""});
}

TEST_F(AssessmentCommands, CompetencePlansTheLimitAndPrintsBothErrorRates) {
  const json shipped = answer("competence plan");
  EXPECT_EQ(shipped["limit"], 11.3);
  EXPECT_NEAR(shipped["false_pass"].get<double>(), 0.0247, 5e-5);
  ASSERT_EQ(shipped["declared_if_failing"].size(), 5U);
  EXPECT_EQ(shipped["declared_if_failing"][4]["declared"], shipped["false_pass"]);
  EXPECT_TRUE(shipped["false_fail_kept"].get<bool>());
  EXPECT_NEAR(shipped["false_alarm"].get<double>(), 0.0131, 5e-5);
  const json old = answer(
      "competence plan --adequate 0.1 --inadequate 0.2 --attempts 50 --false-pass 0.05 "
      "--session-correlation 0 "
      "--lag-correlation 0");
  EXPECT_EQ(old["limit"], 2.85);
  EXPECT_FALSE(old["false_fail_kept"].get<bool>());
  const ProgramRun nobody =
      runTorsio("competence show --login admin --database " + (folder_ / "none.sqlite").string(), folder_);
  EXPECT_EQ(nobody.code, static_cast<int>(ErrorCode::kFileMissing));
  EXPECT_FALSE(fs::exists(folder_ / "none.sqlite"));
}

TEST_F(AssessmentCommands, CompetenceSimulatesTheRuleBesideThePrintedRates) {
  const json out = answer("competence simulate --trainees 2000 --seed 4 --json");
  std::set<std::string> names;
  for (const json& scenario : out["scenarios"]) {
    names.insert(scenario["name"]);
    EXPECT_NEAR(scenario["declared"].get<double>(), scenario["printed"].get<double>(), 0.01) << scenario;
    EXPECT_GT(scenario["printed"].get<double>(), 0.01) << scenario;
    const json& assumed = scenario["assumed"]["inadequate"];  // before the centre has enough runs
    EXPECT_LE(assumed["declared"].get<double>(), assumed["printed"].get<double>() + 0.01) << scenario;
  }
  EXPECT_THAT(names, ::testing::IsSupersetOf({"independent", "force_limit", "session_effect", "lag_0.2",
                                              "lag_0.4", "cut_at_second_miss"}));
  EXPECT_EQ(out, answer("competence simulate --trainees 2000 --seed 4 --json"));
  // A limit of one's own is kept, and what is printed follows it.
  const json own = answer("competence simulate --trainees 500 --json --design " +
                          write("design.json", R"({"adequate": 0.05, "inadequate": 0.3, "limit": 3})"));
  for (const json& scenario : own["scenarios"]) {
    EXPECT_EQ(scenario["limit"], 3);
    EXPECT_GT(scenario["printed"].get<double>(), 0.1) << scenario;
  }
  expectRefused("competence simulate --design " + write("bad.json", "[]"), {"not a JSON object"});
  expectRefused("competence simulate --design " + write("zero.json", R"({"limit": 0})"), {"limit"});
}

Scene shippedScene(const std::string& id, const std::string& pattern = {}) {
  SceneRequest request;
  request.assets = assetsFolder();
  request.id = id;
  request.pattern = pattern;
  return loadScene(request);
}

const std::string kRecordedTrial = "00000000-0000-4000-8000-000000000006";

/// Records the trial of a scripted hand.
TrialSummary recordTrial(const Scene& scene, double duration_s, const fs::path& file) {
  TrialFileSink sink(file);
  ScriptedTrial trial;
  trial.recording.trialId = kRecordedTrial;
  trial.duration_s = duration_s;
  return recordScriptedTrial(scene, trial, sink);
}

TEST_F(AssessmentCommands, MetricsMeasureEveryTwistOfATrialFile) {
  const Scene scene = shippedScene("forearm");
  const fs::path file = folder_ / "trial.bin";
  const TrialSummary summary = recordTrial(scene, 20.0, file);

  const json out = answer("metrics --cards --scene --force-limit 0.01 " + file.string());
  EXPECT_EQ(out["trial"], kRecordedTrial);
  EXPECT_EQ(out["samples"], summary.samples);
  EXPECT_NEAR(out["whole"]["time.total"]["value"].get<double>(), 20.0, 0.01);
  ASSERT_GE(out["twists"].size(), 1U);
  EXPECT_EQ(out["tolerance_rad"], scene.pattern.tolerance_rad);
  EXPECT_EQ(out["twists_completed"].get<std::size_t>() + out["twists_not_completed"].get<std::size_t>(),
            out["twists"].size());
  EXPECT_EQ(out["attempt"]["twist.targets_reached"], out["twists_on_target"]);
  for (const json& twist : out["twists"]) {
    const json& metrics = twist["metrics"];
    EXPECT_GT(metrics["time.total"]["value"].get<double>(), 0.0);
    EXPECT_GT(metrics["torque.peak"]["value"].get<double>(), 0.0);
    EXPECT_GE(metrics["force.peak"]["value"], metrics["force.mean"]["value"]);
    EXPECT_TRUE(metrics["twist.axis_wander"]["value"].is_number());
    EXPECT_TRUE(metrics["twist.rmse"]["value"].contains("undefined")) << "no course was shown";
    EXPECT_TRUE(metrics["shear.over_limit"]["value"].contains("undefined")) << "no limit was given";
  }
  EXPECT_EQ(out["cards"]["force.peak"]["unit"], "N");
}

TEST_F(AssessmentCommands, MetricsReportHowLongACurvedOrganWasStrained) {
  const Scene scene = shippedScene("stomach");
  const fs::path file = folder_ / "stomach.bin";
  recordTrial(scene, 10.0, file);
  const double atTarget_Pa = scene.peakShear_Pa(scene.stateAt(scene.pattern.targetAngle_rad));
  const auto overLimit_s = [&](double limit_Pa) {
    const json out =
        answer("metrics --organ stomach --shear-limit " + std::to_string(limit_Pa) + " " + file.string());
    return out["whole"]["shear.over_limit"]["value"].get<double>();
  };

  const double beyondHalf_s = overLimit_s(0.5 * atTarget_Pa);
  const double beyondTenth_s = overLimit_s(0.1 * atTarget_Pa);

  EXPECT_GT(beyondHalf_s, 0.5);
  EXPECT_GT(beyondTenth_s, beyondHalf_s);
  EXPECT_LT(beyondTenth_s, 10.0);
  EXPECT_EQ(overLimit_s(10.0 * atTarget_Pa), 0.0);  // this run never reaches ten times as much
}

TEST_F(AssessmentCommands, MetricsOfAnUntwistingSayWhichLimitOfItsWallItPasses) {
  const Scene scene = shippedScene("sigmoid", "detorse");
  const fs::path file = folder_ / "sigmoid.bin";
  recordTrial(scene, 2.0, file);

  const json wall = answer("metrics " + file.string())["detorsion"];

  EXPECT_EQ(wall.at("valid"), false) << "it comes turned by more than 104 degrees";
  EXPECT_NEAR(degrees(wall.at("valid_to_rad").get<double>()), 104.0, 1.5);
  EXPECT_NE(wall.at("beyond").get<std::string>().find("folds are checked up to 0.5"), std::string::npos);
}

TEST_F(AssessmentCommands, MetricsOfUnknownTrialsAreRejected) {
  const ProgramRun run = runTorsio("metrics 0 --database " + (folder_ / "none.sqlite").string(), folder_);
  EXPECT_EQ(run.code, static_cast<int>(ErrorCode::kFileMissing)) << run.err;
  const ProgramRun text = runTorsio("metrics " + write("trial.txt", "no trial\n"), folder_);
  EXPECT_NE(text.code, 0);
  EXPECT_LT(text.code, 70) << text.err;
}

using MarksCommands = TableCommands;

/// Two groups of six, three raters; `holes`: rows left empty.
std::string marks(const std::vector<std::string>& holes = {}) {
  std::string table = "subject,group,occasion,rater,score\n";
  for (int i = 0; i < 12; ++i) {
    for (const char* occasion : {"before", "after"}) {
      for (int r = 0; r < 3; ++r) {
        const std::string key = "s" + std::to_string(i) + "," + occasion + ",r" + std::to_string(r);
        const bool hole = std::find(holes.begin(), holes.end(), key) != holes.end();
        const int later = occasion[0] == 'a' ? 2 + 3 * (i % 2) + (i * 5) % 3 : 0;
        const int mark = 10 + (i * 7) % 11 + later + 2 * r + (i * 3 + r * 5) % 4;
        table += "s" + std::to_string(i) + ",g" + std::to_string(i % 2) + "," + occasion + ",r" +
                 std::to_string(r) + "," + (hole ? "" : std::to_string(mark)) + "\n";
      }
    }
  }
  return table;
}

TEST_F(MarksCommands, NamesSubjectsWithMissingMarksAndComparesAll) {
  const json out =
      answer("compare-groups --lowest 1 --highest 60 --margin 4 " +
             write("marks.csv", marks({"s3,after,r1", "s4,after,r0", "s4,after,r1", "s4,after,r2"})));
  const json& mixed = out["mixed_model"];
  EXPECT_EQ(mixed["left_out_subjects"], json::array({"s4"}));
  EXPECT_EQ(out["ancova"]["left_out_subjects"], json::array({"s4"}));
  EXPECT_EQ(mixed["subjects"], 11);
  EXPECT_EQ(mixed["marks"], 32);
  ASSERT_EQ(mixed["missing_marks"].size(), 2U);
  EXPECT_EQ(mixed["missing_marks"][0]["subject"], "s3");
  EXPECT_EQ(mixed["missing_marks"][1]["outcome"], 3);
  const json& pair = mixed["pairs"][0];
  EXPECT_LT(pair["interval"]["lower"], pair["estimate"]);
  EXPECT_LE(mixed["bounds"][0]["worst"]["difference"], pair["estimate"]);
  EXPECT_GE(mixed["bounds"][0]["best"]["difference"], pair["estimate"]);
  EXPECT_EQ(pair["equivalence"]["margin"], 4.0);
  EXPECT_EQ(out["welch_t"]["equivalence"]["margin"], 4.0);
}

TEST_F(MarksCommands, ADroppedGroupIsNamedAndTheOthersAreCompared) {
  std::string table = marks();
  for (const char* subject : {"u1", "u2", "u3"}) {
    table += std::string(subject) + ",g2,before,r0,12\n";
  }
  const json out = answer("compare-groups --lowest 1 --highest 60 " + write("marks.csv", table));
  const json two = answer("compare-groups " + write("two.csv", marks()));
  EXPECT_EQ(out["left_out_groups"], json::array({"g2"}));
  EXPECT_TRUE(two["left_out_groups"].empty());
  EXPECT_EQ(out["groups"][2]["n"], 0);
  for (const char* test : {"welch_anova", "anova", "kruskal_wallis", "brown_forsythe"}) {
    EXPECT_EQ(out[test]["p"], two[test]["p"]) << test;
  }
  for (const char* model : {"ancova", "mixed_model", "mixed_anova"}) {
    EXPECT_EQ(out[model]["left_out_groups"], json::array({"g2"})) << model;
  }
  EXPECT_EQ(out["ancova"]["pairs"].size(), 1U);
  EXPECT_EQ(out["ancova"]["pairs"][0]["p"], two["ancova"]["pairs"][0]["p"]);
  EXPECT_EQ(out["mixed_model"]["adjusted_means"].size(), 2U);
  EXPECT_EQ(out["mixed_anova"]["interaction"]["p"], two["mixed_anova"]["interaction"]["p"]);
  EXPECT_EQ(out["tukey"]["pairs"].size(), 1U);
  EXPECT_EQ(out["mixed_model"]["bounds"].size(), 3U);
}

TEST_F(MarksCommands, CompleteMarksAreComparedLikeTheirMeans) {
  const json out = answer("compare-groups " + write("marks.csv", marks()));
  EXPECT_NEAR(out["mixed_model"]["pairs"][0]["p"].get<double>(),
              out["ancova"]["pairs"][0]["pooled"]["p"].get<double>(), 1e-8);
  EXPECT_TRUE(out["mixed_model"]["missing_marks"].empty());
  EXPECT_EQ(out["ancova"]["left_out"], 0);
}

TEST_F(MarksCommands, PrintsResidualsOfEachSubjectForPlots) {
  const std::string file = write("marks.csv", marks({"s4,after,r0", "s4,after,r1", "s4,after,r2"}));
  EXPECT_FALSE(answer("compare-groups " + file)["ancova"].contains("residuals"));
  const json left = answer("compare-groups --residuals " + file)["ancova"]["residuals"];
  ASSERT_EQ(left.size(), 11U);  // without s4
  double sum = 0.0;
  double quantiles = 0.0;
  for (const json& one : left) {
    EXPECT_NE(one["subject"], "s4");
    sum += one["residual"].get<double>();
    quantiles += one["normal_quantile"].get<double>();
    for (const json& other : left) {  // the larger residual has the larger quantile
      EXPECT_FALSE(one["residual"] < other["residual"] && one["normal_quantile"] > other["normal_quantile"]);
    }
  }
  EXPECT_NEAR(sum, 0.0, 1e-9);
  EXPECT_NEAR(quantiles, 0.0, 1e-9);
}

TEST_F(MarksCommands, NamesTheCovariateOccasion) {
  const std::string file = write("marks.csv", marks());
  const ProgramRun silent = runTorsio("compare-groups " + file, folder_);
  EXPECT_NE(silent.err.find("\"after\" is adjusted for \"before\""), std::string::npos) << silent.err;
  const ProgramRun named = runTorsio("compare-groups --covariate before " + file, folder_);
  EXPECT_EQ(named.err, "");
  EXPECT_EQ(silent.out, named.out);
  const json reversed = answer("compare-groups --occasion before --covariate after " + file);
  EXPECT_EQ(reversed["ancova"]["covariate"], "after");
  EXPECT_EQ(reversed["ancova"]["outcome"], "before");
  EXPECT_TRUE(answer("compare-groups --occasion before " + file)["ancova"].contains("undefined"));
  expectRefused("compare-groups --covariate later " + file, {"later", "--covariate"},
                ErrorCode::kBadParameter);
  expectRefused("compare-groups --covariate after " + file, {"adjust themselves"}, ErrorCode::kBadParameter);
  expectRefused("compare-groups --lowest 5 --highest 2 " + file, {"lowest"}, ErrorCode::kBadParameter);
}

TEST_F(MarksCommands, RejectsADuplicateMarkOfARater) {
  expectRefused("compare-groups " + write("twice.csv", "subject,group,rater,score\na,x,r,1\na,x,r,2\n"),
                {"line 3", "second score", "rater \"r\""});
}

TEST_F(MarksCommands, RandomPermutationsHaveAStatedError) {
  std::string table = "subject,group,score\n";
  for (int i = 0; i < 160; ++i) {
    table += "s" + std::to_string(i) + ",g" + std::to_string(i % 2) + "," +
             std::to_string((i * 37) % 101 + 12 * (i % 2)) + "\n";
  }
  const std::string file = write("many.csv", table);
  const json first = answer("compare-groups " + file)["permutation"];
  EXPECT_EQ(first["exact"], false);
  EXPECT_EQ(first["seed"], 1);
  EXPECT_GT(first["monte_carlo_error"], 0.0);
  const double t = answer("compare-groups " + file)["student_t"]["p"];
  EXPECT_NEAR(first["p"].get<double>(), t, 0.01);
  const json other = answer("compare-groups --seed 2 " + file)["permutation"];
  EXPECT_NEAR(other["p"].get<double>(), first["p"].get<double>(),
              6.0 * first["monte_carlo_error"].get<double>());
  EXPECT_EQ(first, answer("compare-groups " + file)["permutation"]);
}

}  // namespace

}  // namespace torsio
