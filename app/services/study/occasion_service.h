// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/study/occasion.h"

namespace torsio {

/// Lists the occasions that curricula can name, in order of time. kPersonViewCoded (whoever administers
/// the study).
[[nodiscard]] Occasions knownOccasions(SessionContext& session);

/// Adds an occasion after all others, for every later curriculum ("six months later"). Returns it. Audited.
/// kCurriculumEdit. Throws Error{kBadParameter} without a name or when another occasion has it.
Occasion addOccasion(SessionContext& session, const std::string& label);

}  // namespace torsio
