// SPDX-License-Identifier: GPL-3.0-or-later
// Cases F1 to F8 and P1 of the haptics plan, seen from the motors: what the fake device is made to render.
// The governor alone: force_governor_test.cpp.
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/sim/device/hdapi_bench.h"

namespace torsio {
namespace {

constexpr double kRounding_N = 1e-9;

class HdapiForces : public testing::HdapiBench {
 protected:
  HdapiForces() {
    const FakePose pose{{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
    fake.set_pose(&pose);
  }
  /// A tick that writes without any governor: the driver's own border must hold.
  struct Bare {
    HdapiDevice* device = nullptr;
    Vec3 force_N;
    static void tick(void* context, std::int64_t) {
      auto& bare = *static_cast<Bare*>(context);
      bare.device->write({bare.force_N, 0});
    }
  };
  Bare bare;
  void startBare(const Vec3& force_N) {
    open();
    bare = {device.get(), force_N};
    device->enableForce(true);
    device->start({&Bare::tick, &bare});
    fake.run(1'000);
  }
};

TEST_F(HdapiForces, F1_NeverRendersMoreThanTheDevicesMaximumWhateverIsWritten) {
  startBare(Vec3{10.0, 10.0, 10.0} / std::sqrt(3.0));

  EXPECT_NEAR(norm(rendered_N()), 3.3, kRounding_N);
}

TEST_F(HdapiForces, F1_RendersInTheDevicesAxesWhatIsMeantInTheWorlds) {
  startBare({0.1, 0.2, 0.3});

  // World (left, back, up) is device (right, away from the user, up): x, -z, y.
  EXPECT_NEAR(norm(rendered_N() - Vec3{0.1, 0.3, -0.2}), 0.0, kRounding_N);
}

TEST_F(HdapiForces, F3_RendersNothingForForcesAndPosesThatAreNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  startBare({0.5, 0.0, 0.0});
  ASSERT_NEAR(rendered_N().x, 0.5, kRounding_N);

  bare.force_N = {kNan, 0.0, 0.0};
  fake.run(1);
  EXPECT_EQ(rendered_N(), Vec3{});
  bare.force_N = {0.5, 0.0, 0.0};
  fake.run(700);
  ASSERT_NEAR(rendered_N().x, 0.5, kRounding_N);

  const FakePose broken{{0, 0, 0}, {0, 0, 0}, 1, {kNan, 0, 0}};
  fake.set_pose(&broken);
  fake.run(1);
  EXPECT_EQ(rendered_N(), Vec3{});
  EXPECT_TRUE(device->snapshot().sample.status & kDeviceInvalid);
}

TEST_F(HdapiForces, F4_OpensTheGateFromZeroWithAMonotoneRamp) {
  open();
  bare = {device.get(), {3.0, 0.0, 0.0}};
  device->enableForce(true);
  device->start({&Bare::tick, &bare});
  double before_N = 0.0;
  for (int i = 0; i < 520; ++i) {
    fake.run(1);
    const double now_N = rendered_N().x;
    ASSERT_GE(now_N, before_N);
    ASSERT_LE(now_N - before_N, 3.0 / 500.0 + kRounding_N);  // 3 N over the 500 ms of the gate
    before_N = now_N;
  }
  EXPECT_NEAR(before_N, 3.0, kRounding_N);
}

TEST_F(HdapiForces, F7_FadesTheForceOutsideTheWorkspaceThatTheDeviceReports) {
  loop.wanted_N = {0.5, 0.0, 0.0};
  engage();
  ASSERT_NEAR(rendered_N().x, 0.5, kRounding_N);

  // 4 mm a tick is within a hand's reach; the box ends at 80 mm, with the stylus at 119 mm, gone 10 mm later.
  for (int i = 1; i <= 35; ++i) {
    const FakePose pose{{0, 0, 0}, {0, 0, 0}, 1, {4.0 * i, 0, 0}};
    fake.set_pose(&pose);
    fake.run(1);
  }
  fake.run(50);

  EXPECT_EQ(rendered_N(), Vec3{});
  EXPECT_TRUE(loop.sent.limits & kForceWorkspace);
}

class HdapiExit : public HdapiForces {
 protected:
  /// Zero force was sent before the scheduler stopped, then: stop, unschedule, disable.
  void expectOrderedExit(int begin) {
    const std::vector<int> off = logged("hdDisable", begin);
    const std::vector<int> stop = logged("hdStopScheduler", begin);
    const std::vector<int> unschedule = logged("hdUnschedule", begin);
    const std::vector<int> disable = logged("hdDisableDevice", begin);
    ASSERT_TRUE(off.size() == 1 && stop.size() == 1 && unschedule.size() == 1 && disable.size() == 1);
    EXPECT_TRUE(off[0] < stop[0] && stop[0] < unschedule[0] && unschedule[0] < disable[0]);
    std::array<double, 3> last{1, 1, 1};
    fake.commanded(last.data());
    EXPECT_EQ(last, (std::array<double, 3>{}));
    EXPECT_EQ(fake.callbacks(), 0);
    EXPECT_EQ(fake.running(), 0);
    EXPECT_EQ(fake.off_thread(), 0);
    EXPECT_EQ(fake.errors_pending(), 0);
  }
};

TEST_F(HdapiExit, F8_SendsZeroForceAndTearsDownInOrderWhenClosed) {
  startBare({0.5, 0.0, 0.0});
  ASSERT_NEAR(rendered_N().x, 0.5, kRounding_N);
  const int begin = fake.log_count();

  EXPECT_TRUE(device->close());

  expectOrderedExit(begin);
  // The frame with the zero force lies before the stop.
  EXPECT_GT(logged("hdStopScheduler", begin)[0], logged("hdEndFrame", begin).at(0));
}

TEST_F(HdapiExit, F8_DoesTheSameWhenAnExceptionPasses) {
  int begin = 0;
  try {
    startBare({0.5, 0.0, 0.0});
    begin = fake.log_count();
    const std::unique_ptr<HdapiDevice> local = std::move(device);
    throw std::runtime_error("something else failed");
  } catch (const std::runtime_error&) {
    expectOrderedExit(begin);
  }
}

TEST_F(HdapiExit, F8_NeverCallsTheLoopAgainOnceClosingHasBegun) {
  start();
  fake.run(10);

  device->beginClose();
  const std::int64_t ticks = loop.ticks;
  fake.run(10);
  (void)device->close();

  EXPECT_EQ(loop.ticks, ticks);
}

/// A hand's mass against a wall: the plant of the sampled-data passivity condition b > K T / 2 + |B|.
struct Hand {
  double mass_kg = 0.1;
  double damping_Ns_per_m = 0.0;  // physical
  double x_m = 0.0;
  double v_m_per_s = 0.0;
  double taken_J = 0.0;  // by the hand from the motors

  static void move(void* context, std::int64_t, const double* force_N, FakePose* pose) {
    auto& hand = *static_cast<Hand*>(context);
    constexpr int kSubsteps = 100;
    constexpr double kStep_s = 1e-3 / kSubsteps;
    for (int i = 0; i < kSubsteps; ++i) {
      hand.v_m_per_s += (force_N[0] - hand.damping_Ns_per_m * hand.v_m_per_s) / hand.mass_kg * kStep_s;
      hand.x_m += hand.v_m_per_s * kStep_s;
      hand.taken_J += force_N[0] * hand.v_m_per_s * kStep_s;
    }
    *pose = {{0, 0, 0}, {0, 0, 0}, 1, {1e3 * hand.x_m, 0, 0}};
  }
};

struct Wall {
  HdapiDevice* device = nullptr;
  double rest_m = 0.0;
  double stiffness_N_per_m = 0.0;
  static void tick(void* context, std::int64_t time_us) {
    auto& wall = *static_cast<Wall*>(context);
    const double x_m = toolState(wall.device->read(time_us)).pose.position_m.x;
    wall.device->write({{-wall.stiffness_N_per_m * (x_m - wall.rest_m), 0.0, 0.0}, 0});
  }
};

TEST_F(HdapiForces, P1_IsPassiveBelowTheSampledDataBoundAndGeneratesEnergyAboveIt) {
  // K = 400 N/m held over T = 1 ms needs b > K T / 2 = 0.2 N s/m of physical damping. The force that a tick
  // computes is rendered from that tick on, so the delay is the half period of the hold.
  const auto run = [this](double damping_Ns_per_m) {
    fake.reset();
    Hand hand;
    hand.damping_Ns_per_m = damping_Ns_per_m;
    fake.set_pose_function(&Hand::move, &hand);
    open();
    Wall wall{device.get(), 0.0, 400.0};
    device->enableForce(true);
    device->start({&Wall::tick, &wall});
    fake.run(700);
    hand.taken_J = 0.0;
    hand.v_m_per_s = 0.05;  // a push
    const double given_J = 0.5 * hand.mass_kg * 0.05 * 0.05;
    fake.run(3'000);
    const double stored_J = 0.5 * hand.mass_kg * hand.v_m_per_s * hand.v_m_per_s;
    device.reset();
    return std::array<double, 3>{given_J, stored_J, hand.taken_J};
  };

  const auto [given_J, calm_J, calmTaken_J] = run(0.3);
  const auto [alsoGiven_J, wild_J, wildTaken_J] = run(0.1);

  EXPECT_LT(calm_J, 0.01 * given_J);
  EXPECT_GT(wild_J, alsoGiven_J);
  EXPECT_GT(wildTaken_J, calmTaken_J);
}

}  // namespace
}  // namespace torsio
