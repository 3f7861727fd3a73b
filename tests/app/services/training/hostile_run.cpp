// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/services/training/hostile_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "app/services/recording/kept_digests.h"
#include "app/services/recording/recorded_run.h"
#include "sim/core/angle.h"
#include "sim/core/pose.h"
#include "sim/core/random.h"
#include "sim/core/time_units.h"
#include "sim/device/virtual/pointer_device.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial.h"
#include "sim/servo/hand_task.h"
#include "tests/app/support/training_centre.h"

namespace torsio {

namespace {

constexpr std::array<std::int64_t, 5> kPeriods_ms{1, 2, 5, 8, 16};
constexpr double kFarthestJump_m = 0.03;
constexpr std::uint64_t kShippedEvery = 5;
constexpr double kLongestUntwisting_s = 60.0;

/// Random choices with the vocabulary of this file.
class Chance {
 public:
  Chance(std::uint64_t seed, std::uint64_t stream) : random_(Random::forStream(seed, stream)) {}
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * random_.uniform(); }
  [[nodiscard]] bool in(double share) { return random_.uniform() < share; }
  [[nodiscard]] Vec3 direction() {
    return normalized(Vec3{random_.normal(), random_.normal(), random_.normal() + 1e-9});
  }
  template <typename List>
  [[nodiscard]] auto oneOf(const List& list) {
    return list[random_.bounded(list.size())];
  }

 private:
  Random random_;
};

/// Makes any device worse: slow, weak, jumping, failing.
class WorseDevice final : public HapticDevice {
 public:
  WorseDevice(std::unique_ptr<HapticDevice> inner, std::uint64_t seed, std::uint64_t stream)
      : inner_(std::move(inner)), chance_(seed, stream), capabilities_(inner_->capabilities()) {
    period_ms_ = chance_.oneOf(kPeriods_ms);
    capabilities_.maxForce_N = chance_.between(0.5, 8.0);
    capabilities_.continuousForce_N = capabilities_.maxForce_N * chance_.between(0.2, 1.0);
    for (double* share : {&atTouch_, &atRelease_, &atSeam_}) {
      *share = chance_.in(0.5) ? chance_.between(0.0, 1.0) : 0.0;
    }
    anywhere_ = chance_.in(0.3) ? 1e-3 : 0.0;
    failing_ = chance_.in(0.2) ? 5e-4 : 0.0;
  }
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override {
    const std::int64_t tick = time_us / kTickPeriod_us;
    if (tick % period_ms_ == 0) {
      const bool held = sample_.grip > 0;
      sample_ = inner_->read(time_us);
      released_ = held && sample_.grip == 0;
    }
    DeviceSample now = sample_;
    if (jumpsAt(tick)) {
      const Vec3 off_m = chance_.direction() * chance_.between(0.0, kFarthestJump_m);
      now.position[0] += static_cast<std::int32_t>(off_m.x / kPositionStep_m);
      now.position[1] += static_cast<std::int32_t>(off_m.y / kPositionStep_m);
      now.position[2] += static_cast<std::int32_t>(off_m.z / kPositionStep_m);
    }
    if (tick >= fineFrom_ && failing_ > 0.0 && chance_.in(failing_)) {
      trouble_ = chance_.oneOf(std::array<std::uint32_t, 3>{kDeviceLost, kDeviceInvalid, kDeviceStale});
      fineFrom_ = tick + static_cast<std::int64_t>(chance_.between(1.0, 200.0));
    }
    now.status |= tick < fineFrom_ ? trouble_ : kDeviceOk;
    released_ = false;
    touched_ = false;
    return now;
  }
  void write(const ForceCommand& command) noexcept override {
    const bool felt = norm(command.force_N) > 0.0;
    touched_ = felt && !felt_;
    felt_ = felt;
    inner_->write(command);
  }

 private:
  bool jumpsAt(std::int64_t tick) noexcept {
    const std::int64_t place = tick % kSamplesPerChunk;
    const bool atSeam = place == 0 || place == kSamplesPerChunk - 1;
    return (touched_ && chance_.in(atTouch_)) || (released_ && chance_.in(atRelease_)) ||
           (atSeam && chance_.in(atSeam_)) || (anywhere_ > 0.0 && chance_.in(anywhere_));
  }

  std::unique_ptr<HapticDevice> inner_;
  Chance chance_;
  DeviceCapabilities capabilities_;
  std::int64_t period_ms_ = 1;
  double atTouch_ = 0.0;
  double atRelease_ = 0.0;
  double atSeam_ = 0.0;
  double anywhere_ = 0.0;
  double failing_ = 0.0;
  DeviceSample sample_;
  std::uint32_t trouble_ = kDeviceOk;
  std::int64_t fineFrom_ = 0;
  bool felt_ = false;
  bool touched_ = false;
  bool released_ = false;
};

/// Direction from which a task approaches its organ.
struct Approach {
  Vec3 grasp_m;
  Vec3 outward;  // unit vector
  Vec3 axis;     // unit vector
};

Approach approachOf(const HandTask& task) {
  const Vec3 grasp_m = task.turns.empty() ? task.graspPoint_m : task.turns.front().graspPoint_m;
  const Vec3 way_m = grasp_m - task.axisCentre_m;
  const Vec3 across_m = way_m - task.axisDirection * dot(way_m, task.axisDirection);
  return {grasp_m, normalized(across_m), task.axisDirection};
}

/// The stylus points along -z of its pose: here against `outward`.
Quat facing(const Approach& from) {
  const Vec3 x = cross(from.axis, from.outward);
  const Vec3& y = from.axis;
  const Vec3& z = from.outward;
  return rotationFromRows({x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z}).value();
}

/// The wheel advances notch by notch whatever the organ does; then a grip, a turn, and a release.
class WheelHand final : public HapticDevice {
 public:
  WheelHand(const Approach& from, double target_rad, Chance& chance)
      : from_(from),
        pointer_({from.grasp_m + from.outward * kAway_m, facing(from)}),
        notches_(static_cast<int>(chance.between(7.0, 40.0))),
        notch_s_(chance.between(0.02, 0.1)),
        turn_rad_(target_rad * chance.between(0.8, 1.2)),
        rate_(chance.between(0.5, 3.0)) {}
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override {
    return pointer_.capabilities();
  }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override {
    const double t = static_cast<double>(time_us) * 1e-6;
    const double pushed = std::min<double>(notches_, std::floor(t / notch_s_));
    const double grips_s = notches_ * notch_s_ + 0.3;
    const double turned = std::clamp((t - grips_s - 0.4) * rate_, 0.0, std::abs(turn_rad_));
    const double opens_s = grips_s + 0.4 + std::abs(turn_rad_) / rate_ + 1.5;
    const bool over = t > opens_s + 0.3;
    pointer_.publish({.present = true,
                      .onPlane_m = from_.grasp_m + from_.outward * kAway_m,
                      .depth_m = over ? 0.0 : kNotch_m * pushed,
                      .view = facing(from_),
                      .yaw_rad = std::copysign(turned, turn_rad_),  // about the organ's axis
                      .grip = t > grips_s && t < opens_s ? 1.0 : 0.0});
    return pointer_.read(time_us);
  }
  void write(const ForceCommand&) noexcept override {}

 private:
  static constexpr double kAway_m = 0.03;
  static constexpr double kNotch_m = 0.004;
  Approach from_;
  PointerDevice pointer_;
  int notches_;
  double notch_s_;
  double turn_rad_;
  double rate_;
};

/// Wanders around the grasping point at every depth.
class WanderingHand final : public HapticDevice {
 public:
  WanderingHand(const Approach& from, Chance& chance)
      : from_(from), reach_m_(chance.between(0.01, 0.06)), rests_s_(chance.between(0.3, 2.0)) {
    for (double& rate : rates_) {
      rate = chance.between(0.5, 6.0);
    }
    if (chance.in(0.5)) {
      capabilities_.drive = TwistDrive::kRoll;
    }
  }
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override {
    const double t = static_cast<double>(time_us) * 1e-6;
    const auto wave = [&](std::size_t i) { return std::sin(rates_[i] * t); };
    DeviceReading reading;
    reading.time_us = time_us;
    reading.pose.position_m = from_.grasp_m + from_.outward * (reach_m_ * wave(0)) +
                              from_.axis * (reach_m_ * wave(1)) +
                              cross(from_.axis, from_.outward) * (reach_m_ * wave(2));
    reading.pose.orientation = axisAngle(from_.axis, 0.8 * wave(3)) * facing(from_);
    reading.roll_rad = 2.0 * wave(4);
    reading.grip = std::fmod(t, 2.0 * rests_s_) > rests_s_ ? 1.0 : 0.0;
    sample_ = quantize(reading, sample_);
    return sample_;
  }
  void write(const ForceCommand&) noexcept override {}

 private:
  Approach from_;
  double reach_m_;
  double rests_s_;
  std::array<double, 5> rates_{};
  DeviceCapabilities capabilities_;
  DeviceSample sample_;
};

struct Shipped {
  const char* scene;
  const char* pattern;
};
/// The first three, one of each kind, are quick: the default number of runs uses only these.
constexpr std::array kShipped{Shipped{"forearm", "pronation"},
                              Shipped{"small-bowel-loop", "detorse"},
                              Shipped{"stomach", "mesentero-axial"},
                              Shipped{"testis", "detorse"},
                              Shipped{"intestine", "loop"},
                              Shipped{"stomach", "organo-axial"},
                              Shipped{"sigmoid", "detorse"},
                              Shipped{"stomach", "partial"},
                              Shipped{"midgut", "detorse"},
                              Shipped{"stomach", "combined"},
                              Shipped{"gastric-organo-axial", "detorse"},
                              Shipped{"gastric-mesentero-axial", "detorse"}};

const Scene& shipped(const Shipped& which) {
  static std::map<std::string, Scene> kLoaded;
  const std::string name = std::string(which.scene) + "/" + which.pattern;
  const auto found = kLoaded.find(name);
  if (found != kLoaded.end()) {
    return found->second;
  }
  SceneRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.id = which.scene;
  request.pattern = which.pattern;
  return kLoaded.emplace(name, loadScene(request)).first->second;
}

/// Moves a planned hand to the wrong side of the organ's axis.
HandTask fromBehind(HandTask task) {
  const auto mirrored = [&](const Vec3& point_m) {
    const Vec3 way_m = point_m - task.axisCentre_m;
    const Vec3 across_m = way_m - task.axisDirection * dot(way_m, task.axisDirection);
    return point_m - across_m * 2.0;
  };
  task.start_m = mirrored(task.start_m);
  task.graspPoint_m = mirrored(task.graspPoint_m);
  for (HandTurn& turn : task.turns) {
    turn.graspPoint_m = mirrored(turn.graspPoint_m);
  }
  return task;
}

struct PlannedHand {
  std::unique_ptr<HapticDevice> device;
  double duration_s = 0.0;
};

PlannedHand planned(const Scene& scene, HandTask task, std::uint64_t stream, Chance& chance) {
  ScriptedHandOptions hand;
  hand.seed = stream + 1;
  hand.duration_s = chance.between(6.0, 14.0);
  hand.task = std::move(task);
  hand.task.tipRadius_m -= std::max(0.0, chance.between(-0.005, 0.010));
  const double skill = chance.between(0.3, 1.0);
  hand.profile = {.initialSkill = skill, .finalSkill = skill};
  auto device = std::make_unique<ScriptedHand>(hand);
  if (!scene.hollow) {
    return {std::move(device), hand.duration_s};
  }
  hand.duration_s = std::min(kLongestUntwisting_s, undone_s(*scene.hollow, *device) + 0.5);
  return {std::make_unique<ScriptedHand>(hand), hand.duration_s};
}

ServoCommand commandBy(Chance& chance, double target_rad) {
  using Kind = ServoCommand::Kind;
  const auto kind =
      chance.oneOf(std::array{Kind::kReleaseTissue, Kind::kSetForceScale, Kind::kSetTarget,
                              Kind::kEnableForce, Kind::kHoldOrgan, Kind::kVent, Kind::kCheckFlow});
  switch (kind) {
    case Kind::kSetForceScale:
      return {kind, chance.between(0.0, 1.0)};
    case Kind::kSetTarget:
      return {kind, target_rad};
    case Kind::kCheckFlow:
      return {kind, std::floor(chance.between(1.0, 3.99))};
    case Kind::kNone:
    case Kind::kReleaseTissue:
    case Kind::kEnableForce:
    case Kind::kHoldOrgan:
    case Kind::kVent:
      break;
  }
  return {kind, chance.in(0.5) ? 1.0 : 0.0};
}

}  // namespace

HostileRun hostileRun(std::uint64_t seed, std::uint64_t stream) {
  Chance chance(seed, 2 * stream);
  HostileRun out;
  const bool isShipped = stream % kShippedEvery == kShippedEvery - 1;
  const Scene& scene =
      isShipped ? shipped(kShipped[(stream / kShippedEvery) % kShipped.size()]) : trainingBar();
  out.scene = scene.id + "/" + scene.pattern.id;
  out.hand = chance.in(0.4) ? HostileHand::kCareful : chance.oneOf(kHostileHands);
  const double target_rad = isShipped ? scene.pattern.targetAngle_rad : radians(chance.between(20.0, 100.0));
  RecordingSpec spec;
  spec.trialId = "run " + std::to_string(stream);
  spec.targetAngle_rad = target_rad;
  const HandTask task =
      scene.hollow ? detorseTask(scene, detorsionSeed(spec.trialId)) : handTask(scene, target_rad);

  PlannedHand hand;
  hand.duration_s = chance.between(4.0, 10.0);
  switch (out.hand) {
    case HostileHand::kCareful:
      hand = planned(scene, task, stream, chance);
      break;
    case HostileHand::kFromBehind:
      hand = planned(scene, fromBehind(task), stream, chance);
      break;
    case HostileHand::kWheel:
      hand.device = std::make_unique<WheelHand>(approachOf(task), target_rad, chance);
      break;
    case HostileHand::kWandering:
      hand.device = std::make_unique<WanderingHand>(approachOf(task), chance);
      break;
  }
  const bool disturbed = chance.in(0.7);
  if (disturbed) {
    hand.device = std::make_unique<WorseDevice>(std::move(hand.device), seed, 2 * stream + 1);
  }
  const bool commanded = chance.in(0.3);
  if (chance.in(0.25)) {
    hand.duration_s *= chance.between(0.2, 1.0);
  }

  MemoryTrialSink sink;
  RecordedRun run(borrowed(scene), std::move(hand.device), spec, borrowed<TrialSink>(sink));
  for (std::int64_t left = ticksIn(hand.duration_s); left > 0;) {
    const std::int64_t some = std::min(left, ticksIn(chance.between(0.1, 2.0)));
    run.step(some);
    left -= some;
    if (commanded && chance.in(0.3)) {
      static_cast<void>(run.command(commandBy(chance, target_rad)));
    }
  }
  static_cast<void>(run.finish(TrialOutcome::kCompleted));
  out.trial = sink.trial();
  const bool aims = out.hand == HostileHand::kCareful || out.hand == HostileHand::kFromBehind;
  const double tolerance_rad = radians(aims ? chance.between(4.0, 20.0) : chance.between(20.0, 120.0));
  out.rules = recordedRules({.tolerance_rad = tolerance_rad}, out.trial.header);
  return out;
}

}  // namespace torsio
