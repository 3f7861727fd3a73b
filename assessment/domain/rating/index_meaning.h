// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "sim/core/text.h"

namespace torsio {

/// Definition of an evaluation index in one sentence, with the meaning of its lowest, middle and highest
/// mark. The paper (section 5.3) names the nine indices without defining them: the wording is ours.
struct IndexMeaning {
  Text definition;
  Text lowest;
  Text middle;
  Text highest;
};

/// Returns the meaning of an index of paperInstrument(); empty for any other index.
[[nodiscard]] std::optional<IndexMeaning> indexMeaning(std::string_view indexId);

}  // namespace torsio
