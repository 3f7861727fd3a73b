// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/repository/system/schema_tables.h"

namespace torsio {

/// Fills every table of the schema with at least one row: people, trials and marks as the program makes them,
/// so that the audit trail verifies; the rest with generated values that satisfy the column rules. Real rows
/// once, simulated rows once; names and codes begin with `prefix`. New tables are filled automatically; a
/// column with a rule of its own needs an entry in full_record.cpp.
struct FullRecord {
  FullRecord(Connection& connection, const std::string& prefix, bool demonstration);

  TraineeId traineeId;
  RaterId raterId;
  TrialId trialId;
};

/// Prints a digest in failure messages.
void PrintTo(const TableDigest& digest, std::ostream* out);

}  // namespace torsio
