// SPDX-License-Identifier: GPL-3.0-or-later
// torsio agreement against the reference cases of tests/data/assessment.
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
      addRow(table, {named("t", i), meter, json(flow[i]).dump()});
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
