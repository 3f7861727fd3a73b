// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include "app/outputs/tables/export_table.h"
#include "sim/core/foreign_recording.h"
#include "sim/record/trial.h"

namespace torsio {

/// What a line of a trajectory holds, in its order: time from the start of the recording, pose of the
/// instrument, jaw, twist, torque, forces on the tissue and on the hand, stage, contact. SI but for the
/// angle.
[[nodiscard]] const std::vector<ExportColumn>& trajectoryColumns();

/// One line of a trajectory for so many samples: what other equipment recorded, seldom enough, is written as
/// it is.
[[nodiscard]] inline std::int64_t linesEvery(const TrialHeader& header, std::int64_t every) {
  return isForeign(header.sceneId) ? 1 : every;
}

enum class TrajectoryForm {
  kCsv,   ///< comma-separated under a line of names
  kBids,  ///< tab-separated without names, as Motion-BIDS wants it
};

/// Writes every `every`-th sample of a recording as a line; numbers with all their digits. Of a recording of
/// other equipment (isForeign) only time, path and jaw have values. Returns the number of lines. Throws
/// Error{kBadData} for a recording that is not whole, ContractError for `every` < 1.
std::int64_t writeTrajectory(const Trial& trial, std::int64_t every, TrajectoryForm form, std::ostream& out);

}  // namespace torsio
