// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "app/services/people/people_service.h"
#include "app/services/people/roster_import.h"
#include "assessment/domain/people/person.h"

namespace torsio {

// Interprets one line of a roster before anything is stored.

/// Returns the index of a field in a row's values.
[[nodiscard]] constexpr std::size_t rosterIndex(RosterField field) noexcept {
  return static_cast<std::size_t>(field);
}

/// Existing people by number.
struct KnownPeople {
  struct Known {
    PersonEntry entry;
    PersonId id;
    std::string code;
    bool left = false;
  };
  std::map<std::string, Known> byNumber;
  std::map<std::string, std::string> codeByLikeness{};  ///< keyed by likenessOf() the number
  std::map<std::string, std::string> codeByEmail;       ///< keyed by likenessOf() the address
  std::map<std::string, std::string> numberByEmail;     ///< likewise
  std::vector<SeniorityClass> classes;
};

/// Reads the people of the record with their names; the session must have the right.
[[nodiscard]] KnownPeople readKnown(SessionContext& session);
/// Throws Error{kBadParameter} if a required column is missing, a column does not exist or is used twice.
void checkColumns(const RosterFile& file, RosterKind kind, const RosterColumns& columns);
/// Marks a row as rejected; the first reason counts.
void refuseRow(RosterRow& row, const Text& problem, const Text& remedy);
/// Adds a warning to a row that does not stop the import.
void addHint(RosterRow& row, const Text& hint);
/// Normalises the values of a row, or rejects the row.
void understand(RosterRow& row, RosterKind kind, const KnownPeople& known);
/// Compares a row with the existing person of the same number.
void compareWithKnown(RosterRow& row, RosterKind kind, const KnownPeople& known);
/// Writes a normalised value into an entry.
void setValue(PersonEntry& entry, RosterField field, const std::string& value);

}  // namespace torsio
