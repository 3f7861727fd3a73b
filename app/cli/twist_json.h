// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "app/cli/rod_twist.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/rod_organ.h"
#include "sim/scene/scene.h"

namespace torsio::cli {

// Output of `torsio twist` by kind of organ. docs/cli.md lists the keys.

/// By section: position, angle and twist rate by the twist model.
[[nodiscard]] nlohmann::ordered_json angleProfile(const TwistModel& model, const TwistState& state);
/// By section: position and twist rate of an organ modelled as a rod.
[[nodiscard]] nlohmann::ordered_json twistProfile(const Scene& scene, const RodPose& pose);
/// By section: position and rotation about its own tangent, with those of the reference if present.
[[nodiscard]] nlohmann::ordered_json turnProfile(const RodTwistResult& twist);
/// By section: position, rotation and radius of an organ that is twisted initially.
[[nodiscard]] nlohmann::ordered_json hollowProfile(const Scene& scene, const OrganState& state);

/// Torque, compliance and the twist model's measures of the shape.
[[nodiscard]] nlohmann::ordered_json modelResult(const Scene& scene, const TwistState& state);
/// Result of a pattern's task for an organ modelled as a rod.
[[nodiscard]] nlohmann::ordered_json taskResult(const Scene& scene, const TaskPoint& point);
/// State of an initially twisted organ at an angle and the pressure of its scene.
[[nodiscard]] nlohmann::ordered_json hollowResult(const HollowOrgan& organ, const OrganState& state);

}  // namespace torsio::cli
