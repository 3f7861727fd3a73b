// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"

namespace torsio {

/// A person's rows in one table.
struct PersonTable {
  std::string table;
  std::vector<std::string> columns;
  std::vector<std::vector<Value>> rows;
};

/// Returns everything stored about a person, without empty tables. Recordings are listed by trial and chunk;
/// load them with TrialRepository.
[[nodiscard]] std::vector<PersonTable> exportPerson(Connection& connection, const PersonId& personId);

/// Erases a person: removes identity, demographics, recordings, comments, sign-in and drafts; keeps code,
/// marks, results and audit trail, so that statistics do not change. One transaction. Throws Error (kBadData)
/// if the person is unknown or already erased.
void erasePerson(Connection& connection, const PersonId& personId, const std::string& requestedBy,
                 const std::string& reason, std::int64_t utc_us);

}  // namespace torsio
