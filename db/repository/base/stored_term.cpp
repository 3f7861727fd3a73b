// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/stored_term.h"

#include "db/connection/db_error.h"

namespace torsio {

void refuseStoredTerm(const std::string& column, const std::string& stored) {
  throw DbError(DbFault::kCheck, "SELECT " + column,
                Text::tr("the column %1 holds \"%2\", which this version does not know", column, stored),
                Text::tr("database"), Text::tr("Update Torsio on this machine, or restore a backup"));
}

}  // namespace torsio
