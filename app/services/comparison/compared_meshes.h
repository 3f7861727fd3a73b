// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/services/comparison/comparison_run.h"

namespace torsio {

/// Brings reference, finite elements and springs to equilibrium on meshes of half and two thirds of the
/// ridges, steps and rings beside that of the comparison (whose models `result` has): how far each is from
/// its own limit. Uses two threads.
[[nodiscard]] std::vector<ComparedMesh> comparedMeshes(const Scene& scene, const ComparedOrgan& organ,
                                                       const TwistModel& twist,
                                                       const ComparisonResult& result);

}  // namespace torsio
