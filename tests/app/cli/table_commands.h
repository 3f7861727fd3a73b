// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "tests/app/cli/program.h"

namespace torsio::test {

/// Tables in a folder of their own, and the commands that read them.
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

}  // namespace torsio::test
