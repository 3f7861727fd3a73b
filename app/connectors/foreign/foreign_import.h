// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "app/connectors/foreign/foreign_map.h"
#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "app/services/study/landed_study.h"

namespace torsio {

/// What was imported.
struct ForeignOutcome {
  LandedOutcome landed{};
  std::size_t trials = 0;
  std::int64_t samples = 0;
  std::size_t marks = 0;
  std::string contentHash{};  ///< BLAKE2b-256 over the map and the files in order
};

/// Imports recordings of other equipment, described by a map, into a new cohort: people under new codes,
/// recordings of the scene kForeignScene, and their raters' marks. All or nothing. Positions are kept in
/// steps of 0.1 um, rotations in steps of 2^-30, plus jaw and time in microseconds; the parameters hold
/// source, frame, unit and hash. Recordings without a start time start at the time of the import, one
/// microsecond apart. Audited with `reason`. requireLanding(). Throws Error as readForeignMap() and
/// readForeignMotion() do, and {kBadData} for a position beyond 200 m. Whatever `progress` throws cancels the
/// import.
ForeignOutcome importForeign(SessionContext& session, ForeignLayout layout, const std::filesystem::path& map,
                             const std::string& reason, const ProgressCallback& progress = {});

}  // namespace torsio
