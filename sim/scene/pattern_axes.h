// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "sim/geometry/lattice/section_lattice.h"
#include "sim/scene/scene_file.h"
#include "sim/tissue/twist/twist_operation.h"

namespace torsio {

/// Puts the straight axes of a pattern, written for the landmarks of a shipped organ, into another organ: the
/// long axis through its ends, held at both of them, the short one across its bend at half length. An organ
/// without a bend has its short axis along e1 of its middle section.
[[nodiscard]] TwistPattern patternFor(const SectionLattice& lattice, const PatternDescription& description);

}  // namespace torsio
