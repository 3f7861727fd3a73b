// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "app/services/base/csv_table.h"

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

}  // namespace torsio
