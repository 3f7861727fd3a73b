// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "app/web/binary_container.h"
#include "sim/scene/blood_map.h"
#include "sim/scene/organ_state.h"

namespace torsio::web {

/// Adds the colours of BloodMap::evaluate() in every frame as layers that a page mixes in the same order:
/// "fed", each vertex's share in the twisted vessels; "blood", their factor in each frame; meta "paints"
/// {factor, from, to} and "paint", one share per vertex each: bruises, tears and clips of frames from .. to -
/// 1. A bruise by the jaw lasts to the end. No effect for an organ without blood.
void addBloodPaint(BinaryContainer& container, const BloodMap& map, std::span<const OrganState> states,
                   std::span<const std::size_t> stateOfFrame);

}  // namespace torsio::web
