// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/services/base/csv_table.h"
#include "assessment/statistics/values.h"

namespace torsio {

// Tables for setting pass marks (assessment/statistics/standard_setting.h). Each function throws
// Error{kBadData} naming the line of a missing, duplicate or invalid value. Any thread.

/// Percentage of borderline trainees who would succeed, estimated by each judge.
struct JudgedItems {
  std::vector<std::string> judges{};
  std::vector<std::string> items{};
  NumberTable percent{};  ///< judges x items, 0 to 100
};
/// Reads the columns judge, item and percent; every judge must have judged every item.
[[nodiscard]] JudgedItems readJudgedItems(const CsvTable& table);

/// Scores and global ratings of the same subjects.
struct RatedScores {
  std::vector<double> ratings{};
  std::vector<double> scores{};
};
/// Reads the columns subject, global and score.
[[nodiscard]] RatedScores readRatedScores(const CsvTable& table);

/// Scores of people classified as not yet competent, and as competent.
struct ContrastedScores {
  std::vector<double> novices{};
  std::vector<double> masters{};
};
/// Reads the columns subject, group (novice or master) and score.
[[nodiscard]] ContrastedScores readContrastedScores(const CsvTable& table);

/// Reads the columns expert and value.
[[nodiscard]] std::vector<double> readExpertValues(const CsvTable& table);

}  // namespace torsio
