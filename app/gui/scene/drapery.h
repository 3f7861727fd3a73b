// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/scene/organ_surface.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::gui {

/// Cloth that hides where a body ends; visual only, nothing touches it. Closed surfaces, metres.

/// The drape over the upper arm: from a hem just above the arm's lower end down to the ground and out of the
/// picture. `arm`: at rest, hand up. View frame, but in metres.
[[nodiscard]] TriangleMesh drapeOverArm(const OrganSurface& arm, float ground_mm);

/// The sleeve of the gown over the end of a glove's cuff, along the shaft and out of the picture. Frame of
/// the instrument.
[[nodiscard]] TriangleMesh gownSleeve(const TriangleMesh& glove);

}  // namespace torsio::gui
