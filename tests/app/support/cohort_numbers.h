// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/base/csv_table.h"
#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"

namespace torsio {

/// The numbers of cohort.csv by section, group, model, index, occasion and statistic.
class CohortNumbers {
 public:
  explicit CohortNumbers(const std::filesystem::path& file)
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

  /// Returns the raters' marks in the format of `torsio evaluate`.
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

/// Computes the evaluation from the report's ratings with the command line, in `folder`, and compares.
inline void expectEvaluationOfTheCommand(const CohortNumbers& report, const std::filesystem::path& folder) {
  writeFileAtomically(folder / "ratings.csv", report.ratings());
  const ProgramRun evaluated = runTorsio("evaluate --ratings " + (folder / "ratings.csv").string() +
                                             " --class-weights intern=0.2,deputy_chief=0.3,chief=0.5",
                                         folder);
  ASSERT_EQ(evaluated.code, 0) << evaluated.err;
  const nlohmann::json evaluation = nlohmann::json::parse(evaluated.out);
  ASSERT_EQ(evaluation["models"].size(), 3U);
  for (const nlohmann::json& model : evaluation["models"]) {
    const std::string name = model["model"];
    EXPECT_EQ(report.at("evaluation", "", name, "", "", "N_eq27"), model["N"].get<double>());
    for (const nlohmann::json& index : model["indices"]) {
      const std::string id = index["index"];
      EXPECT_EQ(report.at("evaluation", "", name, id, "", "M"), index["M"].get<double>());
      EXPECT_EQ(report.at("evaluation", "", name, id, "", "s2_eq26_divisor_n"), index["s2"].get<double>());
      EXPECT_EQ(report.at("evaluation", "", name, id, "", "se_of_M"), index["se"].get<double>());
    }
  }
}

/// Computes the agreement of `marks`, those of the first group at the last occasion, with the command line,
/// and compares.
inline void expectAgreementOfTheCommand(const CohortNumbers& report, const std::string& marks,
                                        const std::filesystem::path& folder) {
  writeFileAtomically(folder / "marks.csv", marks);
  const ProgramRun agreed = runTorsio("agreement --ratings " + (folder / "marks.csv").string(), folder);
  ASSERT_EQ(agreed.code, 0) << agreed.err;
  const nlohmann::json agreement = nlohmann::json::parse(agreed.out);
  EXPECT_EQ(report.at("agreement", "Group 1", "", "", "after 40 min", "icc_2_1"),
            agreement["icc"]["ICC(2,1)"]["estimate"].get<double>());
  EXPECT_EQ(report.at("agreement", "Group 1", "", "", "after 40 min", "icc_2_k"),
            agreement["icc"]["ICC(2,k)"]["estimate"].get<double>());
}

}  // namespace torsio
