// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/outputs/report/report_data.h"

namespace torsio {

/// A folder from which a study's numbers can be computed again in plain R, without Torsio.
struct ReplicationPackage {
  std::filesystem::path folder{};
  std::vector<std::string> files{};  ///< names
  std::string contentHash{};         ///< BLAKE2b-256 of the manifest
};

/// Writes marks, run-level measures, given facts, the expected numbers, codebook, README, manifest with
/// BLAKE2b-256 hashes, and analysis.R (assets/replication). People appear by code. The folder gets its name
/// when it is complete. kReportExportCoded, audited. `inputs` are those of `request`. Throws
/// Error{kFileUnwritable} if the folder exists, kBadData while single marks may not be seen.
ReplicationPackage writeReplication(SessionContext& session, const ReportRequest& request,
                                    const CohortInputs& inputs, const std::filesystem::path& folder);

/// What a check of such a folder found.
struct ReplicationCheck {
  std::int64_t recomputed = 0;          ///< numbers that R computed
  std::vector<Text> differences{};      ///< changed or missing files, numbers that differ; at most 20
  [[nodiscard]] bool same() const noexcept { return differences.empty(); }
};

/// Compares the files with the manifest, runs analysis.R on a copy of the folder, and compares its numbers
/// with the expected ones key by key. Changes nothing in `folder`; takes up to a minute. Needs a
/// QCoreApplication. Throws Error{kFileMissing} if the folder is no such package or R is not installed,
/// kFileUnreadable if R cannot finish.
[[nodiscard]] ReplicationCheck checkReplication(const std::filesystem::path& folder);

}  // namespace torsio
