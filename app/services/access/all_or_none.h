// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "app/services/access/session_context.h"

namespace torsio {

/// Does `acts` as one step: all that services change in it, or nothing. They ask for their own rights. Throws
/// what `acts` throws, DbError; then nothing was changed.
void asOneStep(SessionContext& session, const std::function<void()>& acts);

/// Does `act`, which calls a service, to each of several in their order: all or none. Throws as asOneStep().
template <typename Several, typename Act>
void allOrNone(SessionContext& session, const Several& several, Act act) {
  asOneStep(session, [&] {
    for (const auto& one : several) {
      act(one);
    }
  });
}

}  // namespace torsio
