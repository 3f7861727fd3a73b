// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/virtual/scripted_hand.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/organ_pose.h"
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

namespace {

constexpr std::uint64_t kPlanStream = 2;
constexpr std::uint64_t kWaveStream = 3;
constexpr double kHover_m = 0.030;   // height of the tip above the surface before it approaches
constexpr double kPress_m = 0.0012;  // mean depth of the tip in the organ when the jaw closes
constexpr double kPause_s = 0.4;
constexpr double kLift_s = 0.5;
constexpr double kReturn_rad_per_s = radians(120.0);
constexpr double kShortestTwist_s = 1.0;
constexpr double kClosestGrasp_m = 1e-4;  // nearer to the axis "outward" has no direction
constexpr double kLongest_s = 86400.0;
constexpr double kPressed_s = 0.1;        // of the second button
constexpr double kPressedAfter_s = 0.05;  // the jaw has closed; before it opens: twice as long

/// Flash and Hogan: the smoothest way from 0 to 1 that starts and ends at rest.
double minimumJerk(double x) noexcept {
  const double u = std::clamp(x, 0.0, 1.0);
  return u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
}

/// A normal deviate that never leaves `limit` standard deviations.
double boundedNormal(Random& random, double limit) {
  return std::clamp(random.normal(), -limit, limit);
}

/// The shortest turn that takes +z to the unit vector `to`.
Quat turnOfZ(const Vec3& to) noexcept {
  const double w = 1.0 + to.z;
  if (w < 1e-9) {
    return {0.0, 1.0, 0.0, 0.0};
  }
  return normalized(Quat{w, -to.y, to.x, 0.0});
}

void require(bool good, Phrase what) {
  if (!good) {
    throw Error(ErrorCode::kBadParameter, what, Text::tr("scripted hand"),
                Text::tr("Check the task and the profile"));
  }
}

void check(const ScriptedHandOptions& options) {
  const HandTask& task = options.task;
  require(isFinite(task.start_m) && isFinite(task.graspPoint_m) && isFinite(task.axisCentre_m) &&
              std::isfinite(task.targetAngle_rad) && std::isfinite(task.tipRadius_m) && task.closure >= 0.0 &&
              task.closure <= 1.0,
          Text::tr("the task must be finite"));
  require(std::abs(norm(task.axisDirection) - 1.0) < 1e-9,
          Text::tr("the axis direction must be a unit vector"));
  require(options.duration_s > 0.0 && options.duration_s <= kLongest_s,
          Text::tr("the duration must lie above 0 s and not above a day"));
  require(options.practisedBefore_min >= 0.0 && std::isfinite(options.practisedBefore_min) &&
              options.practiceScale >= 0.0 && std::isfinite(options.practiceScale),
          Text::tr("practice must be finite and not negative"));
  const HandProfile& profile = options.profile;
  require(profile.initialSkill >= 0.0 && profile.finalSkill >= profile.initialSkill &&
              profile.finalSkill <= 1.0 && profile.learningTime_min > 0.0,
          Text::tr("skill must grow from 0 or more to 1 or less"));
  require(profile.tremorFrequency_Hz >= 8.0 && profile.tremorFrequency_Hz <= 12.0,
          Text::tr("the tremor must lie between 8 and 12 Hz"));
}

}  // namespace

ScriptedHand::ScriptedHand(const ScriptedHandOptions& options)
    : task_(options.task), duration_s_(options.duration_s) {
  check(options);
  capabilities_.model = "Scripted hand";
  capabilities_.realTime = false;

  const Vec3 fromCentre = task_.graspPoint_m - task_.axisCentre_m;
  const Vec3 arm = fromCentre - task_.axisDirection * dot(fromCentre, task_.axisDirection);
  require(norm(arm) > kClosestGrasp_m, Text::tr("the grasp point must not lie on the axis"));
  outward_ = task_.outwards == Vec3{} ? normalized(arm) : task_.outwards;
  upright_ = turnOfZ(outward_);

  Random waves = Random::forStream(options.seed, kWaveStream);
  const auto fill = [&waves](auto& set, double lowest_Hz, double highest_Hz) {
    const double amplitude = std::sqrt(2.0 / static_cast<double>(set.size()));
    for (Wave& wave : set) {
      wave.frequency_Hz = lowest_Hz + (highest_Hz - lowest_Hz) * waves.uniform();
      for (std::size_t i = 0; i < kChannels; ++i) {
        const SinCos phase = portableSinCos(2.0 * kPi * waves.uniform());
        wave.sine[i] = amplitude * phase.cos;
        wave.cosine[i] = amplitude * phase.sin;
      }
    }
  };
  constexpr double kTremorSpread_Hz = 0.8;
  fill(tremor_, std::max(8.0, options.profile.tremorFrequency_Hz - kTremorSpread_Hz),
       std::min(12.0, options.profile.tremorFrequency_Hz + kTremorSpread_Hz));
  fill(drift_, 0.1, 0.5);

  Random random = Random::forStream(options.seed, kPlanStream);
  if (!task_.turns.empty()) {
    planTurns(options, random);
    return;
  }
  const HandTurn only{task_.graspPoint_m, task_.targetAngle_rad};
  for (double begin_s = 0.0;;) {
    const double practised_min = options.practisedBefore_min + options.practiceScale * begin_s / 60.0;
    const Cycle cycle = plan(begin_s, skillAfter(options.profile, practised_min), only, random);
    if (!cycles_.empty() && cycle.begins_s[kLegs] > duration_s_) {
      break;
    }
    cycles_.push_back(cycle);
    begin_s = cycle.begins_s[kLegs];
  }
}

void ScriptedHand::planTurns(const ScriptedHandOptions& options, Random& random) {
  double begin_s = 0.0;
  double missed_rad = 0.0;
  for (std::size_t i = 0; i < task_.turns.size(); ++i) {
    HandTurn turn = task_.turns[i];
    const double wanted_rad = turn.angle_rad + missed_rad;
    turn.angle_rad = wanted_rad;
    const double practised_min = options.practisedBefore_min + options.practiceScale * begin_s / 60.0;
    Cycle cycle = plan(begin_s, skillAfter(options.profile, practised_min), turn, random);
    cycle.unclips = i > 0;
    cycle.clipsAfter = i + 1 < task_.turns.size();
    missed_rad = wanted_rad - cycle.held_rad;
    begin_s = cycle.begins_s[kLegs];
    cycles_.push_back(cycle);
  }
}

bool ScriptedHand::pressesSecond(const Cycle& cycle, double t_s) noexcept {
  const double closed_s = t_s - cycle.begins_s[kTwist] - kPressedAfter_s;
  const double opens_s = cycle.begins_s[kOpen] - 2.0 * kPressedAfter_s - t_s;
  const bool unclips = cycle.unclips && closed_s >= 0.0 && closed_s < kPressed_s;
  return unclips || (cycle.clipsAfter && opens_s >= 0.0 && opens_s < kPressed_s);
}

ScriptedHand::Cycle ScriptedHand::plan(double begin_s, double skill, const HandTurn& turn,
                                       Random& random) const {
  Cycle cycle;
  cycle.skill = skill;
  cycle.motion = handMotion(skill);
  const HandMotion& motion = cycle.motion;
  const Vec3 sideways = cross(task_.axisDirection, outward_);
  const Vec3 missed = task_.axisDirection * (motion.graspError_m * boundedNormal(random, 1.5)) +
                      sideways * (motion.graspError_m * boundedNormal(random, 1.5));
  const double depth_m = kPress_m + motion.pressError_m * boundedNormal(random, 2.0);
  cycle.pressed_m = turn.graspPoint_m + missed + outward_ * (task_.tipRadius_m - depth_m);
  cycle.above_m = cycle.pressed_m + outward_ * kHover_m;
  cycle.held_rad = turn.angle_rad + motion.angleError_rad * boundedNormal(random, 2.5);
  cycle.reached_rad =
      cycle.held_rad + turn.angle_rad * motion.overshoot * (1.0 + 0.5 * boundedNormal(random, 2.0));
  if (!task_.turns.empty()) {  // no wrist turns an organ further in one grip
    cycle.held_rad = std::clamp(cycle.held_rad, -kHandTurn_rad, kHandTurn_rad);
    cycle.reached_rad = std::clamp(cycle.reached_rad, -kHandTurn_rad, kHandTurn_rad);
  }

  std::array<double, kLegs> lasts_s{};
  lasts_s[kReach] = motion.reach_s;
  lasts_s[kApproach] = motion.approach_s;
  lasts_s[kClose] = motion.jaw_s;
  lasts_s[kTwist] = std::max(kShortestTwist_s, std::abs(cycle.reached_rad) / motion.meanTwist_rad_per_s);
  lasts_s[kCorrect] = motion.correction_s;
  lasts_s[kHold] = motion.hold_s;
  lasts_s[kOpen] = motion.jaw_s;
  lasts_s[kLift] = kLift_s;
  lasts_s[kReturn] = std::max(motion.reach_s, std::abs(cycle.held_rad) / kReturn_rad_per_s);
  lasts_s[kPause] = kPause_s + turn.rest_s;
  cycle.begins_s[0] = begin_s;
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    cycle.begins_s[leg + 1] = cycle.begins_s[leg] + lasts_s[leg];
  }
  return cycle;
}

std::array<double, 2> ScriptedHand::span_s(std::size_t cycle) const {
  const Cycle& found = cycles_.at(cycle);
  return {found.begins_s[0], found.begins_s[kLegs]};
}

template <std::size_t N>
ScriptedHand::Channels ScriptedHand::sum(const std::array<Wave, N>& waves, double t_s) noexcept {
  Channels total{};
  for (const Wave& wave : waves) {
    const double turns = wave.frequency_Hz * t_s;
    const SinCos phase = portableSinCos(2.0 * kPi * (turns - std::floor(turns)));
    for (std::size_t i = 0; i < kChannels; ++i) {
      total[i] += wave.sine[i] * phase.sin + wave.cosine[i] * phase.cos;
    }
  }
  return total;
}

DeviceReading ScriptedHand::at(double t_s) noexcept {
  while (current_ + 1 < cycles_.size() && t_s >= cycles_[current_ + 1].begins_s[0]) {
    ++current_;
  }
  const Cycle& cycle = cycles_[current_];
  const auto done = [&cycle, t_s](Leg leg) {
    const double begin_s = cycle.begins_s[leg];
    return minimumJerk((t_s - begin_s) / (cycle.begins_s[leg + 1] - begin_s));
  };
  const double returned = done(kReturn);
  const double away = done(kReach) - returned;  // also the share of tremor: the resting hand is still
  const double twisted = done(kTwist);
  const Channels tremor = sum(tremor_, t_s);
  const Channels drift = sum(drift_, t_s);
  const HandMotion& motion = cycle.motion;

  const double planned_rad = cycle.reached_rad * twisted +
                             (cycle.held_rad - cycle.reached_rad) * done(kCorrect) -
                             cycle.held_rad * returned;
  const double angle_rad = planned_rad + motion.drift_rad * drift[3] * (twisted - returned);
  const Vec3 shake_m = (Vec3{tremor[0], tremor[1], tremor[2]} * motion.tremor_m +
                        Vec3{drift[0], drift[1], drift[2]} * motion.drift_m) *
                       away;
  const Vec3 untwisted_m = task_.start_m + (cycle.above_m - task_.start_m) * away +
                           (cycle.pressed_m - cycle.above_m) * (done(kApproach) - done(kLift)) + shake_m;
  const Vec3 turn_rad = Vec3{tremor[3], tremor[4], tremor[5]} * (motion.tremor_rad * away);
  const double turn = norm(turn_rad);

  DeviceReading reading;
  reading.pose.position_m =
      task_.axisCentre_m + rotateAbout(untwisted_m - task_.axisCentre_m, task_.axisDirection, angle_rad);
  const Quat shaken = turn > 0.0 ? axisAngle(turn_rad / turn, turn) : Quat{};
  reading.pose.orientation = axisAngle(task_.axisDirection, angle_rad) * shaken * upright_;
  reading.grip = task_.closure * (done(kClose) - done(kOpen));
  reading.buttons = pressesSecond(cycle, t_s) ? kButtonSecond : 0U;
  return reading;
}

DeviceSample ScriptedHand::read(std::int64_t time_us) noexcept {
  if (!started_) {
    first_us_ = time_us;
  }
  started_ = true;
  const double t_s = static_cast<double>(time_us - first_us_) * 1e-6;
  DeviceReading reading = at(std::clamp(t_s, 0.0, duration_s_));
  reading.time_us = time_us;
  if (t_s > duration_s_) {
    reading.status = kDeviceEnded;
  }
  sample_ = quantize(reading, sample_);
  return sample_;
}

}  // namespace torsio
