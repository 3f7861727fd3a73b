// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/services/access/session_context.h"
#include "assessment/domain/people/outdated_access.h"
#include "sim/core/text.h"

namespace torsio {

/// Returns whose cards and links were made by an earlier version and no longer open anything. kUserManage.
[[nodiscard]] OutdatedAccess outdatedAccess(SessionContext& session);

/// Says how many there are; empty: none.
[[nodiscard]] Text sentenceOf(const OutdatedAccess& outdated);
/// Says where new ones are made.
[[nodiscard]] Text remedyForOutdatedAccess();

}  // namespace torsio
