// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/virtual/hand_profile.h"

#include <algorithm>

#include "sim/core/angle.h"
#include "sim/core/portable_math.h"
#include "sim/core/random.h"

namespace torsio {

HandProfile handProfile(std::uint64_t seed) {
  constexpr std::uint64_t kProfileStream = 1;
  Random random = Random::forStream(seed, kProfileStream);
  HandProfile profile;
  profile.initialSkill = 0.05 + 0.25 * random.uniform();
  profile.finalSkill = 0.80 + 0.18 * random.uniform();
  profile.learningTime_min = 9.0 + 13.0 * random.uniform();
  profile.tremorFrequency_Hz = 9.0 + 2.0 * random.uniform();
  return profile;
}

double skillAfter(const HandProfile& profile, double practised_min) noexcept {
  const double missing = portableExp(-std::max(0.0, practised_min) / profile.learningTime_min);
  return profile.finalSkill - (profile.finalSkill - profile.initialSkill) * missing;
}

HandMotion handMotion(double skill) noexcept {
  const double k = std::clamp(skill, 0.0, 1.0);
  const auto between = [k](double novice, double expert) { return novice + (expert - novice) * k; };
  HandMotion motion;
  motion.reach_s = between(1.6, 0.9);
  motion.approach_s = between(0.9, 0.5);
  motion.jaw_s = between(0.40, 0.22);
  motion.meanTwist_rad_per_s = between(radians(35.0), radians(75.0));
  motion.correction_s = between(0.8, 0.5);
  motion.hold_s = between(1.4, 0.9);
  motion.overshoot = between(0.14, 0.015);
  motion.angleError_rad = between(radians(7.0), radians(1.2));
  motion.graspError_m = between(0.003, 0.0006);
  motion.pressError_m = between(0.0004, 0.0001);
  motion.tremor_m = between(0.00025, 0.00006);
  motion.tremor_rad = between(radians(0.35), radians(0.08));
  motion.drift_m = between(0.0004, 0.0001);
  motion.drift_rad = between(radians(1.4), radians(0.25));
  return motion;
}

}  // namespace torsio
