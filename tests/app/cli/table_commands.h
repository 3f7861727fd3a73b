// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "tests/app/cli/program.h"
#include "tests/assessment/reference_case.h"

namespace torsio {

/// Tables in a temporary folder, and the commands that read them.
class TableCommands : public ::testing::Test {
 protected:
  std::filesystem::path folder_ = emptyFolder("assessment");

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  nlohmann::json answer(const std::string& arguments, int code = 0) const {
    const ProgramRun run = runTorsio(arguments, folder_);
    EXPECT_EQ(run.code, code) << run.err;
    return run.out.empty() ? nlohmann::json() : nlohmann::json::parse(run.out);
  }
  void expectRefused(const std::string& arguments, const std::vector<std::string>& mentions,
                     ErrorCode code = ErrorCode::kBadData) const {
    SCOPED_TRACE(arguments);
    const ProgramRun run = runTorsio(arguments, folder_);
    EXPECT_EQ(run.code, static_cast<int>(code)) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    for (const std::string& mention : mentions) {
      EXPECT_NE(run.err.find(mention), std::string::npos) << mention << " is not in " << run.err;
    }
  }
};

/// "r3": row or column names of the tables below.
inline std::string named(const char* letter, std::size_t i) {
  return letter + std::to_string(i);
}

inline void addRow(std::string& table, const std::vector<std::string>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    table += (i == 0 ? "" : ",") + values[i];
  }
  table += "\n";
}

/// target,rater,score of a matrix with one row per target.
inline std::string ratings(const nlohmann::json& rows) {
  std::string table = "target,rater,score\n";
  for (std::size_t t = 0; t < rows.size(); ++t) {
    for (std::size_t r = 0; r < rows[t].size(); ++r) {
      addRow(table, {named("t", t), named("r", r), rows[t][r].dump()});
    }
  }
  return table;
}

/// subject,occasion,score of lists of equal length, one per occasion.
inline std::string occasions(const std::vector<std::string>& names,
                             const std::vector<std::vector<double>>& scores) {
  std::string table = "subject,occasion,score\n";
  for (std::size_t o = 0; o < names.size(); ++o) {
    for (std::size_t s = 0; s < scores[o].size(); ++s) {
      addRow(table, {named("s", s), names[o], nlohmann::json(scores[o][s]).dump()});
    }
  }
  return table;
}

/// Expects got[key] of a command to match a value of the case.
inline void expectMatch(const nlohmann::json& got, const nlohmann::json& expected, double tolerance,
                        const std::string& what) {
  ASSERT_TRUE(got.is_number()) << what << " is " << got;
  EXPECT_TRUE(test::matches(got.get<double>(), expected.get<double>(), tolerance)) << what;
}

}  // namespace torsio
