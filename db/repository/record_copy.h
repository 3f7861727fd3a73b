// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "db/connection/connection.h"
#include "db/repository/schema_tables.h"

namespace torsio {

/// Hears how far a copy is: the table, rows done, rows of all tables.
using CopyProgress = std::function<void(const std::string& table, std::int64_t done, std::int64_t all)>;

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
