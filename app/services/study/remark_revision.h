// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/rating/remark.h"

namespace torsio {

/// Adds what the actor makes of a remark beside its words so far, with its entry in the audit trail. The
/// caller has asked for the right and found the remark among those that the actor sees. Throws as
/// revisionOf().
void reviseRemark(SessionContext& session, const Remark& remark, const std::string& text);

}  // namespace torsio
