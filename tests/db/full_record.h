// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/repository/system/schema_tables.h"

namespace torsio {

/// Fills every table of the schema with at least one row: people, trials and marks as the program makes them,
/// so that the audit trail verifies; what is left with made-up values that keep the rules of the columns.
/// Once real, once simulated: names and codes begin with `prefix`. A table that is added to the schema is
/// filled by itself; a column with a rule of its own needs a line in full_record.cpp.
struct FullRecord {
  FullRecord(Connection& connection, const std::string& prefix, bool demonstration);

  TraineeId traineeId;
  RaterId raterId;
  TrialId trialId;
};

/// For the messages of failed tests.
void PrintTo(const TableDigest& digest, std::ostream* out);

}  // namespace torsio
