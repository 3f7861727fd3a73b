// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "app/services/study/landed_study.h"

namespace torsio {

/// What came back.
struct DatasetOutcome {
  LandedOutcome landed{};
  std::size_t trials = 0;
  std::size_t marks = 0;
  std::string contentHash{};  ///< BLAKE2b-256 over study.json and the recordings' content hashes
};

/// Brings a data set that exportDataset() wrote whole (DatasetRequest::whole) into this record: curriculum,
/// cohort, people and raters under their codes, occasions, marks, times of training, deviations, recordings
/// bit for bit. All of it or nothing. An export of the cohort gives the same tables, trajectories and
/// recordings again; docs/exchange.md says what it does not give. `assets`: where exercises are looked up.
/// Audited with `reason`. requireLanding(). Throws Error: kFileMissing, kFileUnreadable; kBadData for a
/// folder that is no such data set, was changed, or meets codes, recordings or exercises that do not fit this
/// record; {kBadParameter} for the name of another cohort; what `progress` throws stops it.
DatasetOutcome importDataset(SessionContext& session, const std::filesystem::path& folder,
                             const std::filesystem::path& assets, const std::string& reason,
                             const ProgressCallback& progress = {});

}  // namespace torsio
