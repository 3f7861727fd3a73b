// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "db/repository/system/schema_tables.h"

namespace torsio {

class Connection;

/// Phases of a copy, in order.
enum class CopyPhase { kVerifying, kCopying, kComparing, kVerifyingCopy };

/// Progress of a copy.
struct CopyStep {
  CopyPhase phase = CopyPhase::kVerifying;
  std::string table{};    ///< while copying and comparing
  std::int64_t done = 0;  ///< in this phase: recordings while verifying, otherwise rows
  std::int64_t all = 0;
};
/// Receives the progress of a copy; may throw to cancel and roll back.
using CopyProgress = std::function<void(const CopyStep& step)>;

/// True if the record holds nothing but the migrations' rows. Requires the schema.
[[nodiscard]] bool isEmptyRecord(Connection& connection);

/// Result of a copy.
struct CopyReport {
  std::vector<TableDigest> tables;  ///< parents first; identical on both sides
  std::int64_t rows = 0;
  std::int64_t auditEntries = 0;
};

/// Copies every row of `from` into the empty record `to`, across engines: a snapshot, parents before
/// children, in one transaction. Before the commit, count and hash of every table are compared and the audit
/// trail of `to` is verified. Both must have the newest schema (openRecord). Throws Error: kBadData if `to`
/// is not empty, the schemas differ, or the trail of `from` does not verify; kVerifyFailed if the copy
/// differs. `to` is then unchanged.
[[nodiscard]] CopyReport copyRecord(Connection& from, Connection& to, const CopyProgress& progress = {});

}  // namespace torsio
