// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/geometry/lattice/section_lattice.h"
#include "sim/scene/scene_file.h"

namespace torsio {

/// Puts the task of a pattern, written for the landmarks of a shipped organ, into another organ: the line of
/// a task runs through the organ's ends or across its bend at half length, from the inside (an organ without
/// a bend has it along e1 of its middle section); the turn that counts is that of the gripped section.
[[nodiscard]] TwistPattern patternFor(const SectionLattice& lattice, const PatternDescription& description);

}  // namespace torsio
