// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"

namespace torsio {

/// Provenance of results: formula, inputs, time. Results are recomputed, never changed.
struct AssessmentRun {
  RunId id{};
  std::string formulaVersion{};
  std::string policy{};      ///< treatment of missing marks
  std::string inputsHash{};  ///< hash of the input marks
  std::vector<std::string> flags{};
  std::string softwareVersion{};
  std::int64_t computedUtc_us = 0;
  bool demonstration = false;
};

/// Column of assessment_run that owns a run.
enum class RunOwner { kCampaign, kCohort };

void insertRun(Connection& connection, RunOwner owner, const std::string& ownerId, const AssessmentRun& run);

/// Joins flags with `;` for storage (no flag contains one).
[[nodiscard]] std::string joinFlags(const std::vector<std::string>& flags);

}  // namespace torsio
