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

/// A roster that was imported, and whether it can still be taken back.
struct ImportedRoster {
  std::string id{};
  RosterKind kind = RosterKind::kTrainees;
  std::string importedBy{};  ///< sign-in name; empty: that account is gone
  std::int64_t importedUtc_us = 0;
  std::int64_t added = 0;
  std::int64_t changed = 0;
  std::vector<std::string> codes{};  ///< of those who are left of it
  bool takenBack = false;
  Text hindrance{};  ///< why it cannot be taken back; empty: it can
};

/// Every roster that was imported, newest first. kPersonEdit and kPersonViewIdentity.
[[nodiscard]] std::vector<ImportedRoster> importedRosters(SessionContext& session);

/// Takes imports back, the newest first: all of them whole, or nothing. Whom they added is erased (the code
/// is never given again, the number is free), whom they changed is as before. Accounts that nobody used go
/// with their people. Audited: an entry for each person and one for each import, without names. kPersonEdit,
/// kPersonViewIdentity and kPersonErase; no second person, since nothing is recorded that could be lost.
/// Throws Error{kBadData} that names the first person on whom something hangs, or who was changed since, and
/// for an import that is not there or was taken back already.
void takeBackRosters(SessionContext& session, std::span<const std::string> importIds,
                     const std::string& reason);

// Private to the roster: what an import leaves, so that it can be taken back.

/// Keeps what an import did; belongs into its transaction.
void keepImport(SessionContext& session, RosterKind kind, const std::vector<StoredRosterPerson>& people);
/// Gives what a roster says about somebody, as it is kept with an import.
[[nodiscard]] std::string rosterJson(const PersonEntry& entry);

}  // namespace torsio
