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

/// What was imported.
struct DatasetOutcome {
  LandedOutcome landed{};
  std::size_t trials = 0;
  std::size_t marks = 0;
  std::string contentHash{};  ///< BLAKE2b-256 over study.json and the recordings' content hashes
};

/// Imports a data set that exportDataset() wrote whole (DatasetRequest::whole): curriculum, cohort, people
/// and raters under their codes, occasions, marks, training times, deviations, and recordings bit for bit.
/// All or nothing. Exporting the cohort again gives the same tables, trajectories and recordings;
/// docs/exchange.md lists the exceptions. `assets`: where exercises are looked up. Audited with `reason`.
/// requireLanding(). Throws Error: kFileMissing, kFileUnreadable; kBadData if the folder is not such a data
/// set, was changed, or has codes, recordings or exercises that conflict with this record; {kBadParameter} if
/// a cohort of that name exists. Whatever `progress` throws cancels the import.
DatasetOutcome importDataset(SessionContext& session, const std::filesystem::path& folder,
                             const std::filesystem::path& assets, const std::string& reason,
                             const ProgressCallback& progress = {});

}  // namespace torsio
