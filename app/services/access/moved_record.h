// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/operation.h"
#include "app/services/access/session_context.h"

namespace torsio {

class Connection;

/// Returns where the record went when it was moved to another database; empty: it is the living one.
[[nodiscard]] std::string movedTo(Connection& connection);
/// Returns whether an operation would add something that the moved record would not have. Reading, backups,
/// exports, the trail and erasing people stay possible.
[[nodiscard]] bool addsToTheRecord(Operation operation);

/// Notes that the record was moved to `place`; from now on the services refuse what would add to it, at every
/// station. kDatabaseRestore.
void noteMoved(SessionContext& session, const std::string& place);
/// Makes a moved record the living one again; audited. kDatabaseRestore. Throws Error{kBadParameter} without
/// a reason, {kBadData} if it was not moved.
void takeBackMove(SessionContext& session, const std::string& reason);

}  // namespace torsio
