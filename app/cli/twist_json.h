// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "app/cli/rod_twist.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/rod_organ.h"
#include "sim/scene/scene.h"

namespace torsio::cli {

// What `torsio twist` prints of a twisted organ, by what the organ is. docs/cli.md lists the keys.

/// Section by section: place, angle and twist rate by the twist model.
[[nodiscard]] nlohmann::ordered_json angleProfile(const TwistModel& model, const TwistState& state);
/// Section by section: place and twist rate of an organ that is a rod.
[[nodiscard]] nlohmann::ordered_json twistProfile(const Scene& scene, const RodPose& pose);
/// Section by section: place and turn about its own tangent, with those of the reference where there is one.
[[nodiscard]] nlohmann::ordered_json turnProfile(const RodTwistResult& twist);
/// Section by section: place, turn and radius of an organ that came twisted.
[[nodiscard]] nlohmann::ordered_json hollowProfile(const Scene& scene, const OrganState& state);

/// Torque, compliance and what the twist model says of the shape.
[[nodiscard]] nlohmann::ordered_json modelResult(const Scene& scene, const TwistState& state);
/// What the task of a pattern comes to for an organ that is a rod.
[[nodiscard]] nlohmann::ordered_json taskResult(const Scene& scene, const TaskPoint& point);
/// What an organ that came twisted is like at an angle and the pressure of its scene.
[[nodiscard]] nlohmann::ordered_json hollowResult(const HollowOrgan& organ, const OrganState& state);

}  // namespace torsio::cli
