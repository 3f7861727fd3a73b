// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

enum class Light {
  kGreen,
  kAmber,  ///< good enough to practise, not to be judged by
  kRed,    ///< no scored run
};

/// One line of the device check.
struct ReadinessFinding {
  std::string code{};  ///< "connected", "docked", "calibrated", "force", "rate", "seat"; the window has words
  Light light = Light::kGreen;
  Text detail{};  ///< what was measured, for people who know the device: "0.8 mm", "driver 2023.1"
  Text remedy{};  ///< what to do; empty when nothing
};

/// What is known of the device at this station.
struct DeviceReadiness {
  Text device{};        ///< "Mouse and keyboard", "Touch", "Scripted hand"
  bool haptic = false;  ///< renders force
  std::vector<ReadinessFinding> findings{};

  /// The worst light; red without any finding: a device that was not checked is not ready.
  [[nodiscard]] Light light() const noexcept;
};

/// Looks at the device now. May take seconds; any thread.
using DeviceProbe = std::function<DeviceReadiness()>;

/// Mouse and keyboard: no force is felt, so that runs are practice unless the centre grades without force.
[[nodiscard]] DeviceReadiness pointerReadiness(bool gradedWithoutForce);
/// The same rule for a device that was checked: one that renders force is returned as it is.
[[nodiscard]] DeviceReadiness judgedByForce(DeviceReadiness readiness, bool gradedWithoutForce);

}  // namespace torsio
