// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "app/web/binary_container.h"
#include "sim/scene/blood_map.h"
#include "sim/scene/organ_state.h"

namespace torsio::web {

/// Adds what BloodMap::evaluate() says of each frame, in parts that a page mixes in the same order: "fed",
/// the share of each vertex in the twisted vessels; "blood", their factor in each frame; meta "paints"
/// {factor, from, to} and "paint", one share a vertex each: bruises, tears and clips of the frames from .. to
/// - 1. Nothing for an organ without blood. A bruise of the jaw takes all later frames.
void addBloodPaint(BinaryContainer& container, const BloodMap& map, std::span<const OrganState> states,
                   std::span<const std::size_t> stateOfFrame);

}  // namespace torsio::web
