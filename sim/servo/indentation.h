// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "sim/core/live_types.h"

namespace torsio {

/// Radius of the part of the surface that gives way, as a multiple of the radius of what presses on it.
inline constexpr double kPatchShare = 6.0;

/// How the surface gives way under a part of the instrument of radius a: like a membrane patch that is held
/// on a circle of radius R and pressed by a round part, w(r) = w0 for r <= a, w0 ln(R / r) / ln(R / a) up to
/// R and 0 beyond, against the normal; r: distance from the contact point. A membrane of tension S pushes
/// back by F = 2 pi S w0 / ln(R / a) = k w0, with the k of the contact force (contact_coupling.h): the force
/// that is felt and the dent that is seen are one membrane's.

/// Computes the displacement of a point of the deformed surface, m; the zero vector outside the patch. Any
/// thread.
[[nodiscard]] Vec3 indentationAt(const ContactPatch& patch, const Vec3& point_m) noexcept;

/// Presses the dents of `state` into the vertices of the deformed organ, metres. For views, once a frame
/// after the twist was applied; returns false and leaves everything as it is when nothing is touched. Any one
/// thread; allocates nothing.
bool indentSurface(const LiveState& state, std::span<Vec3> vertices_m) noexcept;

}  // namespace torsio
