// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/scoring/demonstration_marks.h"
#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui::testing {

/// Whoever takes part in the study, as the rule of the simulated marks wants it.
struct Crowd {
  DemonstrationPeople people;
  std::map<std::string, std::string> idOf;    // of a rater's code
  std::map<std::string, std::string> codeOf;  // of an enrolment
};

Crowd crowdOf(AdministratorDesk& office, const CohortId& cohortId, const std::vector<std::string>& chiefs);
/// Every open sheet of the cohort, filled in by the stated rule of the demonstration.
void submitSheets(AdministratorDesk& office, const CohortId& cohortId, const Crowd& crowd);
/// 40 raters, three models, nine indices.
void submitEvaluationMarks(AdministratorDesk& office, const Crowd& crowd);
/// Computes what the exported table says of these marks by the commands, and compares.
void expectNumbersOfTheCommandLine(const std::filesystem::path& table, const Crowd& crowd,
                                   const std::filesystem::path& folder);

}  // namespace torsio::gui::testing
