// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// What an erase does with the rows that concern a person.
enum class OnErase {
  kKeep,    ///< coded rows on which statistics and the audit trail rest
  kClear,   ///< the named columns become null
  kDelete,  ///< the rows go
};

/// How one table concerns a person. Every table of the schema has exactly one rule (tested).
struct PersonRule {
  std::string_view table;
  std::string_view
      condition;  ///< over the person's id, one `?` or more; empty: the table holds nobody's data
  OnErase onErase = OnErase::kKeep;
  std::string_view cleared{};      ///< kClear: "a = NULL, b = NULL"
  std::string_view columns = "*";  ///< what an export shows: no secrets, no bytes of recordings
};

/// In the order in which an erase may proceed.
[[nodiscard]] std::span<const PersonRule> personRules();

/// One table of a person's own data.
struct PersonTable {
  std::string table;
  std::vector<std::string> columns;
  std::vector<std::vector<Value>> rows;
};

/// All that the record holds about a person; tables without such rows are left out. Recordings are listed by
/// trial and chunk; load them with TrialRepository.
[[nodiscard]] std::vector<PersonTable> exportPerson(Connection& connection, const std::string& personId);

/// Erases a person: identity, demographics, recordings, comments, sign-in and drafts go; the code, marks,
/// results and the audit trail stay as a tombstone, so that statistics keep their numbers. One transaction.
/// Throws Error (kBadData) when there is no such person or they were erased already.
void erasePerson(Connection& connection, const std::string& personId, const std::string& requestedBy,
                 const std::string& reason, std::int64_t utc_us);

}  // namespace torsio
