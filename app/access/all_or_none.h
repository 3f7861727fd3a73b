// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/access/session_context.h"
#include "db/connection/connection.h"

namespace torsio {

/// Does something to each of several, in their order: all or none. `act` takes one of `several` and calls a
/// service, which asks for its own right. Throws what `act` throws, DbError; then nothing was done.
template <typename Several, typename Act>
void allOrNone(SessionContext& session, const Several& several, Act act) {
  Transaction transaction(session.connectionWithoutRight());
  for (const auto& one : several) {
    act(one);
  }
  transaction.commit();
}

}  // namespace torsio
