// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QString>

#include "app/services/study/scoring_plan.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/occasion.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio::gui {

// Codes of the record in the user's language; an unknown code is shown unchanged, an empty one as a dash.

/// "half-way"; occasions that a centre added have the centre's names.
[[nodiscard]] QString occasionName(const Occasion& occasion);
/// A level of a BalanceFactor.
[[nodiscard]] QString levelName(const std::string& code);
/// "chief physician"; a centre's own classes are shown by their code.
[[nodiscard]] QString raterClassName(const std::string& code);

}  // namespace torsio::gui
