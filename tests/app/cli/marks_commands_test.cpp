// SPDX-License-Identifier: GPL-3.0-or-later
// compare-groups on marks by rater: missing marks, covariates, margins, permutations beyond counting.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/app/cli/table_commands.h"

namespace torsio {
namespace {

using nlohmann::json;
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
  EXPECT_NEAR(out["mixed_model"]["pairs"][0]["p"].get<double>(), out["ancova"]["pairs"][0]["p"].get<double>(),
              1e-8);
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
