// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_report.h"

namespace torsio {

/// Writes a folder from which a study's numbers can be computed again in plain R, without Torsio: marks,
/// run-level measures, given facts, the expected numbers, the validity argument, codebook, README, a manifest
/// with BLAKE2b-256 hashes, and analysis.R (assets/replication). Returns its files. The folder gets its name
/// when it is complete. Throws Error: kFileUnwritable if the folder exists, kBadParameter while single marks
/// may not be seen.
std::vector<std::filesystem::path> writeReplication(const CohortInputs& inputs,
                                                    const AnalysedCohort& analysed,
                                                    const std::filesystem::path& folder);

/// What a check of such a folder found.
struct ReplicationCheck {
  std::int64_t recomputed = 0;      ///< numbers that R computed
  std::int64_t computed = 0;        ///< of so many; the others are bootstrap limits and the like
  bool ownScript = true;            ///< the folder's script is this program's, which alone is run
  std::vector<Text> differences{};  ///< changed or missing files, numbers that differ; at most 20
  [[nodiscard]] bool same() const noexcept { return differences.empty(); }
};

/// Compares the files with the manifest, runs this program's analysis.R (never the folder's own) on a copy,
/// and takes over what it finds. Changes nothing in `folder`; takes up to a minute. Needs a QCoreApplication.
/// Throws Error: kFileMissing if the folder is no such package or R is not installed, kFileUnreadable for
/// links and pipes or if R cannot finish, kFileUnwritable without a temporary folder.
[[nodiscard]] ReplicationCheck checkReplication(const std::filesystem::path& folder);

}  // namespace torsio
