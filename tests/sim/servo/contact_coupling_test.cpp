// SPDX-License-Identifier: GPL-3.0-or-later
// Contact: its coupling, the dent that is seen, and that no device leads the instrument through an organ, not
// with a wheel, not with a jump, not by swinging the shaft; what presses too deep is felt, and judged.
#include "sim/servo/contact_coupling.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/portable_math.h"
#include "sim/core/random.h"
#include "sim/device/virtual/pointer_device.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/servo_loop.h"
#include "sim/servo/surface_proxy.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {
namespace {

constexpr double kSurface_N_per_m = 500.0;

TEST(ContactCoupling, MeetsASteadyPushWithTheSpringsInSeries) {
  ContactCoupling coupling(kSurface_N_per_m, 1000);

  for (int i = 0; i < 50; ++i) {
    (void)coupling.step(0.002);
  }

  // 500 and 2000 N/m in series are 400 N/m; the surface takes 2000 / 2500 of the way.
  EXPECT_NEAR(coupling.force_N(), 400.0 * 0.002, 1e-12);
  EXPECT_NEAR(coupling.indentation_m(), 0.8 * 0.002, 1e-15);
}

TEST(ContactCoupling, NeverRendersMoreThanTheSurfacesStiffness) {
  ContactCoupling coupling(kSurface_N_per_m, 1000);
  double depth_m = 0.0;
  for (int i = 1; i < 200; ++i) {
    depth_m = 0.003 * (1.0 - std::cos(0.1 * i));
    (void)coupling.step(depth_m);
    ASSERT_LE(coupling.force_N(), kSurface_N_per_m * 0.006);
    ASSERT_GE(coupling.force_N(), 0.0);
  }
}

TEST(ContactCoupling, TakesInMoreWorkThanItGivesBackOverEveryCycle) {
  ContactCoupling coupling(kSurface_N_per_m, 1000);
  double work_J = 0.0;
  double before_m = 0.0;
  double before_N = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double depth_m = 0.002 + 0.001 * std::sin(2.0 * 3.14159265358979 * i / 100.0);
    (void)coupling.step(depth_m);
    // Trapezoid: the continuous coupling's own work, without the hold between ticks.
    if (i > 100) {
      work_J += 0.5 * (coupling.force_N() + before_N) * (depth_m - before_m);
    }
    before_m = depth_m;
    before_N = coupling.force_N();
  }
  EXPECT_GT(work_J, 0.0);
}

TEST(ContactCoupling, EndsWithTheContact) {
  ContactCoupling coupling(kSurface_N_per_m, 1000);
  (void)coupling.step(0.002);

  EXPECT_EQ(coupling.step(-0.001), 0.0);
  EXPECT_EQ(coupling.force_N(), 0.0);
  ContactCoupling fresh(kSurface_N_per_m, 1000);
  EXPECT_EQ(coupling.step(0.001), fresh.step(0.001));
}

constexpr ContactPatch kPatch{{0.1, 0.2, 0.3}, {0.0, 0.0, 1.0}, 0.002, 0.0025, 0.015};
constexpr double kRounding_m = 1e-15;

double depthAt(double r_m) {
  return -indentationAt(kPatch, kPatch.point_m + Vec3{r_m, 0.0, 0.0}).z;
}

TEST(Indentation, FollowsTheMembraneLaw) {
  EXPECT_EQ(depthAt(0.0), kPatch.depth_m);
  EXPECT_NEAR(depthAt(0.0025), kPatch.depth_m, kRounding_m);
  // Half way in the logarithm: r = sqrt(a R).
  EXPECT_NEAR(depthAt(std::sqrt(0.0025 * 0.015)), 0.5 * kPatch.depth_m, kRounding_m);
  EXPECT_NEAR(depthAt(0.005), 0.002 * std::log(3.0) / std::log(6.0), kRounding_m);
  EXPECT_NEAR(depthAt(0.0149999), 0.0, 1e-7);
  EXPECT_EQ(depthAt(0.015), 0.0);
  EXPECT_EQ(depthAt(0.1), 0.0);
}

TEST(Indentation, PushesBackWithTheForceOfItsTension) {
  // F = 2 pi S w0 / ln(R / a) must be the contact force k w0.
  // So S = 500 N/m ln(0.015 / 0.0025) / 2 pi, and the slope of the dent carries F = 2 pi r S |dw/dr| at any r
  // beyond the tip.
  const double tension = 500.0 * std::log(6.0) / (2.0 * kPi);
  const double r_m = 0.006;
  const double step_m = 1e-7;
  const double slope = (depthAt(r_m - step_m) - depthAt(r_m + step_m)) / (2.0 * step_m);
  EXPECT_NEAR(2.0 * kPi * r_m * tension * slope, 500.0 * kPatch.depth_m, 1e-6);
}

TEST(Indentation, MovesTheVerticesOfAViewUnderBothPartsAndNoOthers) {
  LiveState state;
  state.patches = {kPatch, ContactPatch{{0.1, 0.2, 0.4}, {1.0, 0.0, 0.0}, 0.001, 0.0025, 0.015}};
  std::vector<Vec3> vertices_m{{0.1, 0.2, 0.3}, {0.1, 0.2, 0.4}, {0.0, 0.0, 0.0}};

  EXPECT_TRUE(indentSurface(state, vertices_m));

  EXPECT_NEAR(vertices_m[0].z, 0.298, kRounding_m);
  EXPECT_NEAR(vertices_m[1].x, 0.099, kRounding_m);
  EXPECT_EQ(vertices_m[2], Vec3{});
}

TEST(Indentation, MovesNothingOutOfContact) {
  std::vector<Vec3> vertices_m{{0.1, 0.2, 0.3}};

  EXPECT_FALSE(indentSurface(LiveState{}, vertices_m));

  EXPECT_EQ(vertices_m[0], (Vec3{0.1, 0.2, 0.3}));
  EXPECT_EQ(indentationAt(ContactPatch{}, {}), Vec3{});
}

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
      DeviceReading reading{.pose = {{0.09 - 0.18 * std::min(1.0, t / 0.3), 0.001, 0.2}, fromRight()},
                            .grip = t > 0.6 ? 1.0 : 0.0};
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
      DeviceReading reading{.pose = {{0.09 - 0.09 * std::min(1.0, t / 0.5), 0.0, 0.2}, fromRight()}};
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
    DeviceReading reading{.pose = {{0.06 - 0.06 * deep, 0.0, 0.2}, fromRight()}};
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
    DeviceReading reading{.pose = {{0.0, -0.08, 0.2},
                                   axisAngle({1.0, 0.0, 0.0}, radians(-90.0 + 60.0 * t)) *
                                       axisAngle({0.0, 1.0, 0.0}, radians(90.0 - 90.0 * t))}};
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
      DeviceReading reading{
          .pose = {{radius_m + 0.01 - share * (2.0 * radius_m + 0.05), beside_m + bend_m * share, 0.2},
                   fromRight()}};
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
