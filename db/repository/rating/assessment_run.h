// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"

namespace torsio {

/// Where results came from: which formula over which inputs, when. Results are computed anew, never changed.
struct AssessmentRun {
  RunId id{};
  std::string formulaVersion{};
  std::string policy{};      ///< what was done about missing marks
  std::string inputsHash{};  ///< over the marks that went in
  std::vector<std::string> flags{};
  std::string softwareVersion{};
  std::int64_t computedUtc_us = 0;
  bool demonstration = false;
};

/// Which column of assessment_run a run belongs to.
enum class RunOwner { kCampaign, kCohort };

void insertRun(Connection& connection, RunOwner owner, const std::string& ownerId, const AssessmentRun& run);

/// Flags are stored as one text, separated by `;` (no flag contains one).
[[nodiscard]] std::string joinFlags(const std::vector<std::string>& flags);

}  // namespace torsio
