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

// What one line of a roster means, before anything is stored.

/// Gives the place of a field in the values of a row.
[[nodiscard]] constexpr std::size_t rosterIndex(RosterField field) noexcept {
  return static_cast<std::size_t>(field);
}

/// What is known already, found by number.
struct KnownPeople {
  struct Known {
    PersonEntry entry;
    PersonId id;
    std::string code;
    bool left = false;
  };
  std::map<std::string, Known> byNumber;
  std::map<std::string, std::string> codeByLikeness{};  ///< by likenessOf() the number
  std::map<std::string, std::string> codeByEmail;       ///< lower-case address
  std::map<std::string, std::string> numberByEmail;
  std::vector<SeniorityClass> classes;
};

/// Reads the people of the record with their names; the session may see them.
[[nodiscard]] KnownPeople readKnown(SessionContext& session);
/// Refuses a choice of columns that lacks one that is required, names one that does not exist or takes one
/// twice. Throws Error{kBadParameter}.
void checkColumns(const RosterFile& file, RosterKind kind, const RosterColumns& columns);
/// Says why a row cannot be taken; the first reason counts.
void refuseRow(RosterRow& row, const Text& problem, const Text& remedy);
/// Puts the values of a row as the record writes them, or refuses the row.
void understand(RosterRow& row, RosterKind kind, const KnownPeople& known);
/// Compares a row with what is known: by number, and by number alone.
void compareWithKnown(RosterRow& row, RosterKind kind, const KnownPeople& known);
/// Writes a value that was understood into an entry.
void setValue(PersonEntry& entry, RosterField field, const std::string& value);

}  // namespace torsio
