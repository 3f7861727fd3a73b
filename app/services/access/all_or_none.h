// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "app/services/access/session_context.h"

namespace torsio {

/// Runs `acts` in one transaction: all changes of the services it calls, or none. They check their own
/// rights. Throws what `acts` throws, DbError; then nothing was changed.
void asOneStep(SessionContext& session, const std::function<void()>& acts);

/// Calls `act`, which calls a service, for each element in order: all or none. Throws like asOneStep().
template <typename Several, typename Act>
void allOrNone(SessionContext& session, const Several& several, Act act) {
  asOneStep(session, [&] {
    for (const auto& one : several) {
      act(one);
    }
  });
}

}  // namespace torsio
