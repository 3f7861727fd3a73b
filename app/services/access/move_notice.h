// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/operation.h"
#include "app/services/access/session_context.h"
#include "sim/core/text.h"

namespace torsio {

class Connection;

/// Returns one sentence for people who work with a record that moved or is being moved; empty: it is the
/// living one (moved_record.cpp).
[[nodiscard]] Text moveNotice(Connection& connection);

/// Returns whether an operation would add something that the moved record would not have. Reading, backups,
/// exports, the trail and erasing people stay possible.
[[nodiscard]] bool addsToTheRecord(Operation operation);

/// Makes a moved record the living one again; audited. kDatabaseRestore. Throws Error{kBadParameter} without
/// a reason, {kBadData} if it was not moved.
void takeBackMove(SessionContext& session, const std::string& reason);

}  // namespace torsio
