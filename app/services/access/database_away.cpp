// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/database_away.h"

#include "db/connection/db_error.h"

namespace torsio {

bool saysDatabaseAway(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const DbError& error) {
    return error.fault() == DbFault::kUnreachable;
  } catch (...) {
    return false;
  }
}

}  // namespace torsio
