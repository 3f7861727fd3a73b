// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/scoring/demonstration_marks.h"
#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui::testing {

/// The participants of the study, as input of the rule of simulated marks.
struct Crowd {
  DemonstrationPeople people;
  std::map<std::string, std::string> idOf;    // by rater code
  std::map<std::string, std::string> codeOf;  // by enrolment
};

Crowd crowdOf(AdministratorDesk& office, const CohortId& cohortId, const std::vector<std::string>& chiefs);
/// Fills in every open sheet of the cohort by the demonstration's rule.
void submitSheets(StudyCentre& centre, const CohortId& cohortId, const Crowd& crowd);
/// 40 raters, three models, nine indices.
void submitEvaluationMarks(AdministratorDesk& office, const Crowd& crowd);
/// Computes the numbers of the exported table with the command line, and compares.
void expectNumbersOfTheCommandLine(const std::filesystem::path& table, const Crowd& crowd,
                                   const std::filesystem::path& folder);

}  // namespace torsio::gui::testing
