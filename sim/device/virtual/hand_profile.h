// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace torsio {

/// How a simulated person learns and trembles. Assumed ranges, for demonstration only: no such figures are
/// measured for twist exercises.
struct HandProfile {
  double initialSkill = 0.15;        ///< before any practice, 0..1
  double finalSkill = 0.92;          ///< after endless practice, initial..1
  double learningTime_min = 14.0;    ///< time constant of the exponential learning curve, > 0
  double tremorFrequency_Hz = 10.0;  ///< centre of the person's physiological tremor, 8..12
};

/// Makes the person with this seed: initial skill 0.05..0.30, final 0.80..0.98, learning time 9..22 min.
[[nodiscard]] HandProfile handProfile(std::uint64_t seed);

/// Returns the skill after `practised_min` minutes of practice: final - (final - initial) exp(-t / learning
/// time).
[[nodiscard]] double skillAfter(const HandProfile& profile, double practised_min) noexcept;

/// How a hand of one skill moves; linear in skill between a novice (0) and an expert (1).
struct HandMotion {
  double reach_s = 0.0;              ///< way from the start to above the grasp point
  double approach_s = 0.0;           ///< from there into contact
  double jaw_s = 0.0;                ///< closing and opening
  double meanTwist_rad_per_s = 0.0;  ///< mean rate of the main twist (peak: 15/8 of it)
  double correction_s = 0.0;         ///< second movement, from overshoot to the final angle
  double hold_s = 0.0;
  double overshoot = 0.0;       ///< mean share of the target that the main twist exceeds
  double angleError_rad = 0.0;  ///< standard deviation of the final angle
  double graspError_m = 0.0;    ///< standard deviation of the grasp point along the surface
  double pressError_m = 0.0;    ///< standard deviation of the pressing depth
  double tremor_m = 0.0;        ///< of the position, root mean square an axis, 8-12 Hz
  double tremor_rad = 0.0;      ///< of the orientation, root mean square an axis, 8-12 Hz
  double drift_m = 0.0;         ///< of the position, root mean square an axis, 0.1-0.5 Hz
  double drift_rad = 0.0;       ///< of the twist angle, root mean square, 0.1-0.5 Hz
};

[[nodiscard]] HandMotion handMotion(double skill) noexcept;

}  // namespace torsio
