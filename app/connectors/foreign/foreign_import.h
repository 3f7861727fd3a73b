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

/// What came in.
struct ForeignOutcome {
  LandedOutcome landed{};
  std::size_t trials = 0;
  std::int64_t samples = 0;
  std::size_t marks = 0;
  std::string contentHash{};  ///< BLAKE2b-256 over the map and the files in their order
};

/// Reads what other equipment recorded, as the map says, into a cohort of its own: people under new codes,
/// recordings of the scene kForeignScene, marks of their raters. All of it or nothing. What of each file is
/// kept: place in steps of 0.1 um, rotation in steps of 2^-30, jaw, time in microseconds, and in the
/// parameters source, frame, unit and hash. A recording whose start the map does not know begins with the
/// import, each a microsecond after the one before. Audited with `reason`. requireLanding(). Throws Error as
/// readForeignMap() and readForeignMotion() do, {kBadData} for a place beyond 200 m; what `progress` throws
/// stops it.
ForeignOutcome importForeign(SessionContext& session, ForeignLayout layout, const std::filesystem::path& map,
                             const std::string& reason, const ProgressCallback& progress = {});

}  // namespace torsio
