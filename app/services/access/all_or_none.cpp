// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/all_or_none.h"

#include "db/connection/connection.h"

namespace torsio {

void asOneStep(SessionContext& session, const std::function<void()>& acts) {
  Transaction transaction(session.connectionWithoutRight());
  acts();
  transaction.commit();
}

}  // namespace torsio
