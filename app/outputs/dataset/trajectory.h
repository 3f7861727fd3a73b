// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <vector>

#include "app/outputs/tables/export_table.h"
#include "sim/core/foreign_recording.h"
#include "sim/record/trial.h"

namespace torsio {

/// Returns the columns of a trajectory in order: time from the start of the recording, instrument pose, jaw,
/// twist, torque, forces on tissue and hand, stage, contact. SI units except for the angle.
[[nodiscard]] const std::vector<ExportColumn>& trajectoryColumns();

/// Returns the samples per trajectory row; recordings of other equipment, which have low rates, are written
/// completely.
[[nodiscard]] inline std::int64_t linesEvery(const TrialHeader& header, std::int64_t every) {
  return isForeign(header.sceneId) ? 1 : every;
}

enum class TrajectoryForm {
  kCsv,   ///< comma-separated with a header
  kBids,  ///< tab-separated without a header, as in Motion-BIDS
};

/// Returns every `every`-th sample of a recording, by column in the order of trajectoryColumns(); those of
/// other equipment as in writeTrajectory(). Throws like that.
[[nodiscard]] std::vector<std::vector<std::optional<double>>> trajectoryValues(const Trial& trial,
                                                                               std::int64_t every);

/// Writes every `every`-th sample of a recording as a row, with numbers in full precision. Recordings of
/// other equipment (isForeign()) have values only for time, path and jaw. Returns the number of rows. Throws
/// Error{kBadData} for an incomplete recording, ContractError for `every` < 1.
std::int64_t writeTrajectory(const Trial& trial, std::int64_t every, TrajectoryForm form, std::ostream& out);

}  // namespace torsio
