// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// Returns whether the person can be erased now: somebody else has requested it, the centre requires only one
/// person, or the person is simulated. Call after checking kPersonErase.
[[nodiscard]] bool mayEraseNow(SessionContext& session, const PersonId& personId);

/// Erases in one transaction and uses up the request. Call after checking kPersonErase. Throws
/// SecondPersonNeeded, and what erasePerson() throws.
void eraseGuarded(SessionContext& session, const PersonId& personId, const std::string& reason);

}  // namespace torsio
