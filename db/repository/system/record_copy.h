// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "db/repository/system/schema_tables.h"

namespace torsio {

class Connection;

/// What a copy does, in its order.
enum class CopyPhase { kVerifying, kCopying, kComparing, kVerifyingCopy };

/// How far a copy is.
struct CopyStep {
  CopyPhase phase = CopyPhase::kVerifying;
  std::string table{};    ///< while copying and comparing
  std::int64_t done = 0;  ///< of this phase: recordings while verifying, else rows
  std::int64_t all = 0;
};
/// Hears how far a copy is; may throw to give up, then nothing is kept.
using CopyProgress = std::function<void(const CopyStep& step)>;

/// Whether nothing was ever stored there but what the migrations brought. The schema must be there.
[[nodiscard]] bool isEmptyRecord(Connection& connection);

/// What a copy has moved and compared.
struct CopyReport {
  std::vector<TableDigest> tables;  ///< parents first; the same on both sides
  std::int64_t rows = 0;
  std::int64_t auditEntries = 0;
};

/// Copies every row of `from` into the empty record `to`, whatever engine each is: as it was at one moment,
/// parents before their children, in one transaction. Before that is kept, count and hash of every table are
/// compared on both sides and the audit trail of `to` is verified. Both have the newest schema (openRecord).
/// Throws Error: kBadData when `to` is not empty, the schemas differ, or the trail of `from` itself does not
/// verify; kVerifyFailed when the copy is not what was copied. Then `to` is as before.
[[nodiscard]] CopyReport copyRecord(Connection& from, Connection& to, const CopyProgress& progress = {});

}  // namespace torsio
