// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/people/people_service.h"
#include "app/services/people/roster_import.h"
#include "sim/core/text.h"

namespace torsio {

struct StoredRosterPerson;

/// An imported roster, and whether the import can be undone.
struct ImportedRoster {
  std::string id{};
  RosterKind kind = RosterKind::kTrainees;
  std::string importedBy{};  ///< sign-in name; empty: the account is gone
  std::int64_t importedUtc_us = 0;
  std::int64_t added = 0;
  std::int64_t changed = 0;
  std::vector<std::string> codes{};  ///< of the people who are still there
  bool takenBack = false;
  Text hindrance{};  ///< why it cannot be undone; empty: it can
};

/// Returns all imported rosters, latest first. kPersonEdit and kPersonViewIdentity.
[[nodiscard]] std::vector<ImportedRoster> importedRosters(SessionContext& session);

/// Undoes imports, latest first: all completely, or nothing. Added people are erased (their codes are never
/// reused, their numbers are free), changed people are restored. Unused accounts are removed with their
/// people. Audited: an entry per person and per import, without names. kPersonEdit, kPersonViewIdentity and
/// kPersonErase; needs no second person, since nothing recorded is lost. Throws Error{kBadData}, naming the
/// first person with dependent data or later changes, and for an unknown import or one already undone.
void takeBackRosters(SessionContext& session, std::span<const std::string> importIds,
                     const std::string& reason);

// Private to the roster: stored data of an import, for undoing it.

/// Stores what an import did; call it in the import's transaction.
void keepImport(SessionContext& session, RosterKind kind, const std::vector<StoredRosterPerson>& people);
/// Returns the roster's data about a person in the format stored with an import.
[[nodiscard]] std::string rosterJson(const PersonEntry& entry);

}  // namespace torsio
