// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/people/people_service.h"
#include "app/services/people/roster_import.h"
#include "db/repository/people/roster_import_repository.h"

namespace torsio {

// Private to the roster: what an import leaves, so that it can be taken back.

/// Keeps what an import did; belongs into its transaction.
void keepImport(SessionContext& session, RosterKind kind, const std::vector<StoredRosterPerson>& people);
/// Gives what a roster says about somebody, as it is kept with an import.
[[nodiscard]] std::string rosterJson(const PersonEntry& entry);

}  // namespace torsio
