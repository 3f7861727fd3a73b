// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/services/base/csv_table.h"
#include "assessment/statistics/values.h"

namespace torsio {

// Tables from which the line between pass and fail is drawn (assessment/statistics/standard_setting.h). Each
// throws Error{kBadData} that names the line of what is missing, stands twice or is no number. Any thread.

/// Percent of borderline trainees who would succeed, as each judge sees it.
struct JudgedItems {
  std::vector<std::string> judges{};
  std::vector<std::string> items{};
  NumberTable percent{};  ///< judges x items, 0 to 100
};
/// Reads the columns judge, item and percent; every judge judges every item.
[[nodiscard]] JudgedItems readJudgedItems(const CsvTable& table);

/// Scores and global ratings of the same subjects.
struct RatedScores {
  std::vector<double> ratings{};
  std::vector<double> scores{};
};
/// Reads the columns subject, global and score.
[[nodiscard]] RatedScores readRatedScores(const CsvTable& table);

/// Scores of those who are held to be not yet able, and to be able.
struct ContrastedScores {
  std::vector<double> novices{};
  std::vector<double> masters{};
};
/// Reads the columns subject, group (novice or master) and score.
[[nodiscard]] ContrastedScores readContrastedScores(const CsvTable& table);

/// Reads the columns expert and value.
[[nodiscard]] std::vector<double> readExpertValues(const CsvTable& table);

}  // namespace torsio
