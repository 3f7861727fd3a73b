// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/core/text.h"

namespace torsio::web {

/// The sentences that stand in the pages themselves (assets/web), for their translation. A test holds this
/// list and the pages together.
[[nodiscard]] const std::vector<Text>& webTexts();

}  // namespace torsio::web
