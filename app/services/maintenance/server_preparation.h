// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/session_context.h"
#include "app/services/maintenance/maintainer.h"

namespace torsio {

/// Brings the schema of a server up to date and writes the roles (db/repository/people/server_roles.h), as
/// the owner of its tables. Audited. An empty database becomes a record without a centre; then only the
/// system can have been named. kDatabaseRestore. Throws Error: kUsage for a file, kPermission when the
/// account is not the owner; DbError.
void prepareServer(const Maintainer& maintainer, const std::string& locator, const std::string& stationRole);
/// Writes the roles of the server that the session works on. kDatabaseRestore. Throws like the one above.
void prepareServer(SessionContext& session, const std::string& stationRole);

}  // namespace torsio
