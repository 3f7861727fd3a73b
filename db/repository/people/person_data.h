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

/// One table of a person's own data.
struct PersonTable {
  std::string table;
  std::vector<std::string> columns;
  std::vector<std::vector<Value>> rows;
};

/// All that the record holds about a person; tables without such rows are left out. Recordings are listed by
/// trial and chunk; load them with TrialRepository.
[[nodiscard]] std::vector<PersonTable> exportPerson(Connection& connection, const PersonId& personId);

/// Erases a person: identity, demographics, recordings, comments, sign-in and drafts go; the code, marks,
/// results and the audit trail stay as a tombstone, so that statistics keep their numbers. One transaction.
/// Throws Error (kBadData) when there is no such person or they were erased already.
void erasePerson(Connection& connection, const PersonId& personId, const std::string& requestedBy,
                 const std::string& reason, std::int64_t utc_us);

}  // namespace torsio
