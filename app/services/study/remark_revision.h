// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/rating/remark.h"

namespace torsio {

/// Adds a version to a remark, audited. The caller has checked the right and that the actor can see the
/// remark. Throws like revisionOf().
void reviseRemark(SessionContext& session, const Remark& remark, const std::string& text);

}  // namespace torsio
