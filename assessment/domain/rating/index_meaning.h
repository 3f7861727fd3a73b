// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "sim/core/text.h"

namespace torsio {

/// What an index of the evaluation asks, in one sentence, and what its lowest, middle and highest mark mean.
/// The paper (section 5.3) names the nine indices and defines none: the wording is ours.
struct IndexMeaning {
  Text definition;
  Text lowest;
  Text middle;
  Text highest;
};

/// Returns the meaning of an index of paperInstrument(); empty for another one.
[[nodiscard]] std::optional<IndexMeaning> indexMeaning(std::string_view indexId);

}  // namespace torsio
