// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of the commands compared with R (README.md of this folder).
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/cli/program.h"

namespace torsio {
namespace {

constexpr double kRelative = 1e-9;
const std::filesystem::path kHere = std::filesystem::path(TORSIO_SOURCE_DIR) / "tests" / "validation";

struct Case {
  std::string statistic;
  std::string command;
  std::string pointer;
  double value = 0.0;
};

std::vector<Case> cases() {
  std::ifstream file(kHere / "cases.tsv");
  std::vector<Case> found;
  std::string line;
  std::getline(file, line);  // column names
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    Case one;
    std::string value;
    for (std::string* cell : {&one.statistic, &one.command, &one.pointer, &value}) {
      std::getline(cells, *cell, '\t');
    }
    one.value = std::stod(value);
    found.push_back(one);
  }
  return found;
}

/// Inserts the paths of the tables into a command.
std::string withFolder(std::string command) {
  const std::size_t end = command.find(".csv");
  if (end != std::string::npos) {
    command.insert(command.rfind(' ', end) + 1, "'" + (kHere / "tables").string() + "'/");
  }
  return command;
}

TEST(Validation, EveryStatisticOfTheCommandsMatchesR) {
  const std::filesystem::path scratch = emptyFolder("validation");
  std::map<std::string, nlohmann::json> answers;
  const std::vector<Case> all = cases();
  ASSERT_GE(all.size(), 544U);
  for (const Case& one : all) {
    SCOPED_TRACE(one.statistic + ": torsio " + one.command);
    if (!answers.contains(one.command)) {
      const ProgramRun run = runTorsio(withFolder(one.command), scratch);
      ASSERT_EQ(run.code, 0) << run.err;
      answers[one.command] = nlohmann::json::parse(run.out);
    }
    const nlohmann::json::json_pointer where(one.pointer);
    const nlohmann::json& answer = answers[one.command];
    ASSERT_TRUE(answer.contains(where) && answer[where].is_number()) << one.pointer;
    EXPECT_LE(std::abs(answer[where].get<double>() - one.value), kRelative * std::abs(one.value) + 1e-14)
        << one.pointer << " is " << answer[where] << ", R says " << one.value;
  }
}

}  // namespace
}  // namespace torsio
