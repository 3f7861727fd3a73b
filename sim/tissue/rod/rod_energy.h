// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "sim/tissue/rod/grip.h"
#include "sim/tissue/rod/rod_contact.h"

namespace torsio {

/// What a step minimises the energy of: the rod, the jaw that holds it if any, and the start of the step
/// against which its motion is damped. Refers only.
struct RodTask {
  const Rod* rod = nullptr;
  const RodGrip* grip = nullptr;  ///< null: free
  Pose hand{};                    ///< finite; its quaternion is a unit
  std::span<const RodContactPair> near{};
  const RodPose* before = nullptr;  ///< pose at the start of the step; unused without rate
  std::span<const RodStrain> strainsBefore{};
  std::span<const HeldNode> held{};  ///< beside those of the rod
  double rate_per_s = 0.0;           ///< 1 / duration of the step; 0: no damping, the pose at rest is sought
};

/// Returns the energy stored in elements, restraints, contact and jaw. Real time.
[[nodiscard]] double storedEnergy_J(const Rod& rod, const RodPose& pose, const RodGrip* grip,
                                    const Pose& hand) noexcept;

/// Returns stored energy plus what damping and drag take on the way from the start of the step:
///   Pi = E + (eta/2T) h (e - e')^T S (e - e') + (b/2T) |x - x'|^2. Real time.
[[nodiscard]] double stepEnergy_J(const RodTask& task, const RodPose& pose) noexcept;

/// Returns stepEnergy_J() at the start of a step, where nothing has been damped and the strains are known.
/// Real time.
[[nodiscard]] double startEnergy_J(const RodTask& task) noexcept;

}  // namespace torsio
