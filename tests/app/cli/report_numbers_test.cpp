// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of the cohort report are those of the commands, to the last digit.
#include <filesystem>
#include <map>
#include <string>

#include <QCoreApplication>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/base/csv_table.h"
#include "app/scoring/scoring_service.h"
#include "assessment/report/number_format.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/study/study_repository.h"
#include "sim/base/file_io.h"
#include "tests/app/cli/program.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::emptyFolder;
using test::ProgramRun;
using test::runTorsio;

/// The numbers of cohort.csv by section, group, model, index, occasion and statistic.
class Numbers {
 public:
  explicit Numbers(const fs::path& file)
      : table_(CsvTable::read(
            file, {"section", "item", "group", "model", "index", "occasion", "statistic", "value"},
            {"n", "flags"})) {}

  [[nodiscard]] double at(const std::string& section, const std::string& group, const std::string& model,
                          const std::string& index, const std::string& occasion,
                          const std::string& statistic) const {
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      if (table_.cell(row, "item") == "all" && table_.cell(row, "section") == section &&
          table_.cell(row, "group") == group && table_.cell(row, "model") == model &&
          table_.cell(row, "index") == index && table_.cell(row, "occasion") == occasion &&
          table_.cell(row, "statistic") == statistic) {
        return table_.number(row, "value");
      }
    }
    ADD_FAILURE() << section << " " << group << " " << model << " " << index << " " << occasion << " "
                  << statistic;
    return 0.0;
  }

  /// The marks of the raters as `torsio evaluate` reads them.
  [[nodiscard]] std::string ratings() const {
    std::string text = "index,rater,class,model,score\n";
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      if (table_.cell(row, "statistic") == "mark") {
        text += table_.cell(row, "index") + "," + table_.cell(row, "item") + "," + table_.cell(row, "group") +
                "," + table_.cell(row, "model") + "," + table_.cell(row, "value") + "\n";
      }
    }
    return text;
  }

 private:
  CsvTable table_;
};

TEST(ReportNumbers, EqualThoseOfTheCommandsToTheLastDigit) {
  const fs::path folder = emptyFolder("report-numbers");
  ASSERT_EQ(runTorsio("demo --out " + (folder / "out").string() + " --shorten 300 --seed 7", folder).code, 0);
  const Numbers report(folder / "out" / "cohort.csv");

  // Evaluation of the models.
  writeFileAtomically(folder / "ratings.csv", report.ratings());
  const ProgramRun evaluated = runTorsio("evaluate --ratings " + (folder / "ratings.csv").string() +
                                             " --class-weights intern=0.2,deputy_chief=0.3,chief=0.5",
                                         folder);
  ASSERT_EQ(evaluated.code, 0) << evaluated.err;
  const json evaluation = json::parse(evaluated.out);
  ASSERT_EQ(evaluation["models"].size(), 3U);
  for (const json& model : evaluation["models"]) {
    const std::string name = model["model"];
    EXPECT_EQ(report.at("evaluation", "", name, "", "", "N_eq27"), model["N"].get<double>());
    for (const json& index : model["indices"]) {
      const std::string id = index["index"];
      EXPECT_EQ(report.at("evaluation", "", name, id, "", "M"), index["M"].get<double>());
      EXPECT_EQ(report.at("evaluation", "", name, id, "", "s2_eq26_divisor_n"), index["s2"].get<double>());
      EXPECT_EQ(report.at("evaluation", "", name, id, "", "se_of_M"), index["se"].get<double>());
    }
  }

  // Agreement and comparison, from the marks in the record.
  Connection connection = openRecord((folder / "out" / "torsio.sqlite").string(), OpenMode::kReadWrite);
  const TrainingResult training = readTraining(connection, StudyRepository(connection).cohorts().at(0).id);
  const std::vector<std::string> occasions = {"before", "after 20 min", "after 40 min"};
  std::map<std::pair<std::string, std::string>, std::string>
      lines;  // of the last occasion, by trainee and rater
  for (const TrainingMark& mark : training.marks) {
    if (mark.occasion == 2) {
      lines[{mark.trainee, mark.rater}] = mark.trainee + "," + mark.rater + "," +
                                          formatExact(pointsFromSteps(mark.steps, training.scale)) + "\n";
    }
  }
  std::string marks = "target,rater,score\n";
  for (const auto& [key, line] : lines) {
    marks += line;
  }
  writeFileAtomically(folder / "marks.csv", marks);
  const ProgramRun agreed = runTorsio("agreement --ratings " + (folder / "marks.csv").string(), folder);
  ASSERT_EQ(agreed.code, 0) << agreed.err;
  const json agreement = json::parse(agreed.out);
  EXPECT_EQ(report.at("agreement", "", "", "", occasions[2], "icc_2_1"),
            agreement["icc"]["ICC(2,1)"]["estimate"].get<double>());
  EXPECT_EQ(report.at("agreement", "", "", "", occasions[2], "icc_2_k"),
            agreement["icc"]["ICC(2,k)"]["estimate"].get<double>());

  std::string scores = "subject,group,occasion,score\n";
  for (const TraineeScore& score : training.trainees) {
    scores += score.trainee + ",Group " + std::to_string(score.group + 1) + "," + occasions[score.occasion] +
              "," + formatExact(score.score) + "\n";
  }
  writeFileAtomically(folder / "scores.csv", scores);
  const ProgramRun compared = runTorsio("compare-groups " + (folder / "scores.csv").string(), folder);
  ASSERT_EQ(compared.code, 0) << compared.err;
  const json ancova = json::parse(compared.out)["ancova"];
  EXPECT_EQ(report.at("comparison", "", "", "", occasions[2], "ancova_f"), ancova["statistic"].get<double>());
  for (const json& pair : ancova["pairs"]) {
    const std::string name =
        pair["groups"][0].get<std::string>() + " - " + pair["groups"][1].get<std::string>();
    EXPECT_EQ(report.at("comparison", name, "", "", occasions[2], "adjusted_difference"),
              pair["difference"].get<double>());
    EXPECT_EQ(report.at("comparison", name, "", "", occasions[2], "p_holm"), pair["p_holm"].get<double>());
  }
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);  // QtSql loads its drivers through it
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
