// SPDX-License-Identifier: GPL-3.0-or-later
// No device leads the instrument through an organ: not with a wheel, not with a jump, not by swinging the
// shaft; and what presses too deep is felt, and judged.
#include "sim/servo/surface_proxy.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/random.h"
#include "sim/device/virtual/pointer_device.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {
namespace {

constexpr double kThin_m = 0.012;

const Scene& thick() {
  static const Scene kScene = barScene();
  return kScene;
}
const Scene& thin() {
  static const Scene kScene = barScene(testing::prism(testing::circleOutline(kThin_m, 72), kBarLength_m, 40));
  return kScene;
}

/// A hand that goes where it is told and cannot be stopped.
class ProxyHand final : public HapticDevice {
 public:
  using Path = std::function<DeviceReading(double time_s)>;
  explicit ProxyHand(Path path, TwistDrive drive = TwistDrive::kRoll) : path_(std::move(path)) {
    capabilities_.drive = drive;
  }
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override {
    DeviceReading reading = path_(static_cast<double>(time_us) * 1e-6);
    reading.time_us = time_us;
    sample_ = quantize(reading, sample_);
    return sample_;
  }
  void write(const ForceCommand&) noexcept override {}

 private:
  Path path_;
  DeviceCapabilities capabilities_;
  DeviceSample sample_;
};

std::vector<Sample> run(HapticDevice& hand, const Scene& scene, int ticks, bool holdsBack = true) {
  ServoLoop loop({.device = &hand, .scene = &scene},
                 {.drive = hand.capabilities().drive, .holdsBack = holdsBack});
  std::vector<Sample> samples;
  for (int i = 0; i < ticks; ++i) {
    loop.tick(1000LL * i);
    samples.push_back(loop.lastSample());
  }
  return samples;
}

Vec3 tipOf(const Sample& sample) {
  return toolState(sample.device).pose.position_m;
}

double mostForce_N(const std::vector<Sample>& samples) {
  double most_N = 0.0;
  for (const Sample& sample : samples) {
    most_N = std::max(most_N, norm(sample.response.force_N));
  }
  return most_N;
}

/// The stylus comes from +x: its shaft lies behind the tip.
Quat fromRight() {
  return axisAngle({0.0, 1.0, 0.0}, radians(90.0));
}

TEST(SurfaceProxy, StaysOnItsSideAtAnyDepth) {
  for (const Scene* scene : {&thick(), &thin()}) {
    // 15 cm through the middle in 0.3 s, a rest behind, a grip from there.
    ProxyHand hand([](double t) {
      DeviceReading reading;
      reading.pose = {{0.09 - 0.18 * std::min(1.0, t / 0.3), 0.001, 0.2}, fromRight()};
      reading.grip = t > 0.6 ? 1.0 : 0.0;
      return reading;
    });
    const std::vector<Sample> samples = run(hand, *scene, 900);

    for (const Sample& sample : samples) {
      ASSERT_GT(tipOf(sample).x, 0.0);
    }
    // It would have come out of the other side.
    ProxyHand free = hand;
    EXPECT_LT(tipOf(run(free, *scene, 600, false).back()).x, -0.05);
  }
}

TEST(SurfaceProxy, PressingAsDeepAsItGoesPassesAnyLimitOfAnExercise) {
  const auto pressed = [](const Scene& scene) {
    ProxyHand hand([](double t) {
      DeviceReading reading;
      reading.pose = {{0.09 - 0.09 * std::min(1.0, t / 0.5), 0.0, 0.2}, fromRight()};
      return reading;
    });
    return run(hand, scene, 800);
  };

  const std::vector<Sample> deep = pressed(thick());
  EXPECT_GT(mostForce_N(deep), 6.0);             // what a scene allows at most
  EXPECT_GT(mostForce_N(pressed(thin())), 3.3);  // of a bowel it is 2 N
  const auto depth = std::max_element(deep.begin(), deep.end(), [](const Sample& a, const Sample& b) {
    return a.response.depth_m < b.response.depth_m;
  });
  EXPECT_NEAR(depth->response.depth_m, kDeepestPress_m, 1e-3);
  EXPECT_LT(kTooDeep_m, 0.6 * kDeepestPress_m);  // people are told long before
}

TEST(SurfaceProxy, ChangesNothingForACarefulHand) {
  const auto trainee = [] {
    return ScriptedHand({.seed = 7, .task = handTask(thick()), .profile = handProfile(7), .duration_s = 8.0});
  };
  ScriptedHand free = trainee();
  ScriptedHand held = trainee();

  EXPECT_EQ(run(held, thick(), 8000), run(free, thick(), 8000, false));
}

TEST(SurfaceProxy, ReleasesTheHandOutwardsAtOnce) {
  ProxyHand hand([](double t) {
    const double deep = t < 0.5 ? t / 0.5 : std::max(0.0, 1.0 - (t - 0.5) / 0.3);
    DeviceReading reading;
    reading.pose = {{0.06 - 0.06 * deep, 0.0, 0.2}, fromRight()};
    return reading;
  });
  const std::vector<Sample> samples = run(hand, thick(), 1000);

  EXPECT_NEAR(tipOf(samples.back()).x, 0.06, 1e-6);
  EXPECT_EQ(samples.back().phase, ExercisePhase::kTracking);
  EXPECT_EQ(norm(samples.back().response.force_N), 0.0);
}

TEST(SurfaceProxy, TheWheelOfAMouseDoesNotLeadThrough) {
  // The view looks along -x; the wheel pushes the tip 4 mm a notch, forty notches.
  const Quat view = fromRight();
  PointerDevice pointer({{0.06, 0.0, 0.2}, view});
  ServoLoop loop({.device = &pointer, .scene = &thick()}, {.drive = TwistDrive::kRoll, .holdsBack = true});
  for (int notch = 1; notch <= 40; ++notch) {
    pointer.publish({.present = true,
                     .onPlane_m = {0.06, 0.0, 0.2},
                     .depth_m = 0.004 * notch,
                     .view = view,
                     .grip = notch > 35 ? 1.0 : 0.0});
    for (int i = 0; i < 60; ++i) {
      loop.tick(1000LL * (60 * notch + i));
      ASSERT_GT(tipOf(loop.lastSample()).x, kBarRadius_m - kDeepestPress_m - 0.003) << "notch " << notch;
    }
  }
}

TEST(SurfaceProxy, SwingingTheShaftThroughPushesTheTipAway) {
  // The tip beside the bar, the shaft swings right through it about the tip.
  ProxyHand hand([](double t) {
    DeviceReading reading;
    reading.pose = {{0.0, -0.08, 0.2},
                    axisAngle({1.0, 0.0, 0.0}, radians(-90.0 + 60.0 * t)) *
                        axisAngle({0.0, 1.0, 0.0}, radians(90.0 - 90.0 * t))};
    return reading;
  });
  double deepest_m = 0.0;
  for (const Sample& sample : run(hand, thick(), 1500)) {
    deepest_m = std::max(deepest_m, norm(sample.response.force_N) / kContactStiffness_N_per_m);
  }
  EXPECT_LT(deepest_m, kBarRadius_m);
}

// Ways by chance, straight and bent, slow and in jumps. Who comes near the flank slips off there, as from the
// organ itself; nobody gets past the middle, seen from where he arrived.
TEST(SurfaceProxy, NoRandomPathLeadsThrough) {
  for (std::uint64_t stream = 0; stream < 60; ++stream) {
    Random random = Random::forStream(20261125, stream);
    const auto between = [&random](double low, double high) { return low + (high - low) * random.uniform(); };
    const Scene& scene = stream % 2 == 0 ? thick() : thin();
    const double radius_m = stream % 2 == 0 ? kBarRadius_m : kThin_m;
    const double beside_m = between(-0.5, 0.5) * radius_m;
    const double bend_m = between(-0.3, 0.3) * radius_m;
    const double lasts_s = stream % 5 == 0 ? 1e-3 : between(0.05, 1.0);
    ProxyHand hand([=](double t) {
      const double share = std::clamp((t - 0.1) / lasts_s, 0.0, 1.0);
      DeviceReading reading;
      reading.pose = {{radius_m + 0.01 - share * (2.0 * radius_m + 0.05), beside_m + bend_m * share, 0.2},
                      fromRight()};
      return reading;
    });
    Vec3 arrivedFrom;
    for (const Sample& sample : run(hand, scene, 1600)) {
      const Vec3 across{tipOf(sample).x, tipOf(sample).y, 0.0};
      if (norm(across) >= radius_m) {
        arrivedFrom = normalized(across);  // outside, or just touching
      }
      ASSERT_GT(dot(across, arrivedFrom), 0.0) << "stream " << stream << " tick " << sample.tick;
    }
  }
}

}  // namespace
}  // namespace torsio
