// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// Whether somebody else has asked to erase this person, or nobody needs to: the centre asks for one person
/// only, or the person is simulated. In a call that has asked for kPersonErase.
[[nodiscard]] bool mayEraseNow(SessionContext& session, const PersonId& personId);

/// Erases in one transaction, and uses up the request. In a call that has asked for kPersonErase. Throws
/// SecondPersonNeeded, and what erasePerson() throws.
void eraseGuarded(SessionContext& session, const PersonId& personId, const std::string& reason);

}  // namespace torsio
