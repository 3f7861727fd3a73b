// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/core/text.h"

namespace torsio::web {

/// Returns the sentences of the pages (assets/web) for translation. A test compares this list with the pages.
[[nodiscard]] const std::vector<Text>& webTexts();

}  // namespace torsio::web
