// SPDX-License-Identifier: GPL-3.0-or-later
// Cases F1 to F8 and P1 of the haptics plan, seen from the motors: what the fake device is made to render.
// The governor alone: force_governor_test.cpp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "sim/device/safety/passivity.h"
#include "sim/servo/servo_thread.h"
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

TEST_F(HdapiForces, F2_RisesByNoMoreThanATickOverMailboxesThatHandOverSeveralAtOnce) {
  open();
  device->enableForce(true);
  device->start({});
  const auto frame = [this](double force_N) {
    device->write({{force_N, 0.0, 0.0}, 0});
    fake.run(1);
    return rendered_N().x;
  };
  for (int i = 0; i < 700; ++i) {
    (void)frame(0.5);  // until the gate has opened
  }
  ASSERT_NEAR(rendered_N().x, 0.5, kRounding_N);

  // The other side has gone on by three ticks and more since the frame before.
  EXPECT_NEAR(frame(0.81), 0.6, kRounding_N);
  EXPECT_NEAR(frame(0.81), 0.7, kRounding_N);
  EXPECT_NEAR(frame(0.2), 0.2, kRounding_N);    // down at once
  EXPECT_NEAR(frame(-3.0), -0.1, kRounding_N);  // and through zero by a tick's rise
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
  for (int i = 0; i < 570; ++i) {  // the rate is known after 50 ms
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

/// A tick that hangs once, watched as the servo watches it; all on the fake's clock.
struct Watched {
  HdapiDevice* device = nullptr;
  const testing::FakeHd* fake = nullptr;
  ServoWatchdog* dog = nullptr;
  bool hangs = false;

  static void tick(void* context, std::int64_t) {
    auto& watched = *static_cast<Watched*>(context);
    watched.dog->beat(1000 * watched.fake->now_us());
    watched.device->write({{0.5, 0.0, 0.0}, 0});
    if (!std::exchange(watched.hangs, false)) {
      return;
    }
    watched.fake->advance_us(kStall_ns / 1000);
    watched.dog->check(1000 * watched.fake->now_us());
  }
};

TEST_F(HdapiForces, F5_SendsNoForceFromATickThatHungAndRampsAfterwards) {
  open();
  ServoWatchdog dog([this] { device->dropForce(); });
  Watched watched{device.get(), &fake, &dog, false};
  device->enableForce(true);
  device->start({&Watched::tick, &watched});
  fake.run(1'000);
  ASSERT_NEAR(rendered_N().x, 0.5, kRounding_N);

  watched.hangs = true;
  fake.run(1);
  EXPECT_EQ(dog.stalls(), 1);
  EXPECT_EQ(rendered_N(), Vec3{});
  fake.run(10);
  EXPECT_LE(rendered_N().x, 0.5 * 10 / 500 + kRounding_N);
  fake.run(600);
  EXPECT_NEAR(rendered_N().x, 0.5, kRounding_N);
  (void)device->close();
}

TEST_F(HdapiForces, F5_DropsTheForceOfAThreadThatHangsBeforeItWouldExpire) {
  serveHalfNewton();

  device->dropForce();
  fake.run(1);

  EXPECT_EQ(rendered_N(), Vec3{});
}

class HdapiExit : public HdapiForces {
 protected:
  /// Zero force was sent before the scheduler stopped, then: stop, unschedule, disable.
  void expectOrderedExit(int begin) {
    // On a machine that lets the loop wait for 15 ms the watch has switched the output off before.
    const std::vector<int> late = logged("hdDisable", begin);
    const std::vector<int> off = late.empty() ? logged("hdDisable", 0) : late;
    const std::vector<int> stop = logged("hdStopScheduler", begin);
    const std::vector<int> unschedule = logged("hdUnschedule", begin);
    const std::vector<int> disable = logged("hdDisableDevice", begin);
    ASSERT_TRUE(!off.empty() && stop.size() == 1 && unschedule.size() == 1 && disable.size() == 1);
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
  double absorbed_J = 0.0;  // by wall and physical damping together since the push
  double lowest_J = 0.0;

  static void move(void* context, std::int64_t, const double* force_N, FakePose* pose) {
    auto& hand = *static_cast<Hand*>(context);
    constexpr int kSubsteps = 100;
    constexpr double kStep_s = 1e-3 / kSubsteps;
    for (int i = 0; i < kSubsteps; ++i) {
      const double drag_N = -hand.damping_Ns_per_m * hand.v_m_per_s;
      hand.v_m_per_s += (force_N[0] + drag_N) / hand.mass_kg * kStep_s;
      hand.x_m += hand.v_m_per_s * kStep_s;
      hand.absorbed_J -= (force_N[0] + drag_N) * hand.v_m_per_s * kStep_s;
    }
    hand.lowest_J = std::min(hand.lowest_J, hand.absorbed_J);
    *pose = {{0, 0, 0}, {0, 0, 0}, 1, {1e3 * hand.x_m, 0, 0}};
  }
  [[nodiscard]] double energy_J() const { return 0.5 * mass_kg * v_m_per_s * v_m_per_s; }
};

struct Wall {
  HdapiDevice* device = nullptr;
  double stiffness_N_per_m = 400.0;
  bool watched = false;
  PassivityController passivity{PassivityOptions{}};
  std::int64_t damped = 0;

  static void tick(void* context, std::int64_t time_us) {
    auto& wall = *static_cast<Wall*>(context);
    const Vec3 tip_m = toolState(wall.device->read(time_us)).pose.position_m;
    Vec3 force_N{-wall.stiffness_N_per_m * tip_m.x, 0.0, 0.0};
    std::uint32_t limits = kForceFull;
    if (wall.watched) {
      force_N = wall.passivity.control(time_us, tip_m, force_N, true, limits);
    }
    wall.passivity.sent(force_N);
    wall.damped += (limits & kForcePassivity) != 0 ? 1 : 0;
    wall.device->write({force_N, 0});
  }
};

class HdapiWall : public HdapiForces {
 protected:
  struct Outcome {
    Hand hand;
    double given_J = 0.0;
    std::int64_t damped = 0;
  };
  /// Pushes the hand into the wall and lets it swing for three seconds.
  Outcome push(double damping_Ns_per_m, bool watched) {
    Outcome outcome;
    outcome.hand.damping_Ns_per_m = damping_Ns_per_m;
    fake.set_pose_function(&Hand::move, &outcome.hand);
    options.stylusTip_m = 0.0;
    open();
    Wall wall;
    wall.device = device.get();
    wall.watched = watched;
    device->enableForce(true);
    device->start({&Wall::tick, &wall});
    fake.run(700);
    outcome.hand.absorbed_J = 0.0;
    outcome.hand.lowest_J = 0.0;
    outcome.hand.v_m_per_s = 0.05;
    outcome.given_J = outcome.hand.energy_J();
    fake.run(3'000);
    outcome.damped = wall.damped;
    device.reset();
    return outcome;
  }
};

// K = 400 N/m held over T = 1 ms needs b > K T / 2 = 0.2 N s/m of physical damping. The force that a tick
// computes is rendered from that tick on, so the delay is the half period of the hold. Wall and damping
// together are passive when they never give out more than they took; the push is 125 uJ.
constexpr double kEnergyRounding_J = 1e-8;

TEST_F(HdapiWall, P1_IsPassiveAboveTheDampingThatTheHeldForceNeeds) {
  const Outcome outcome = push(0.21, false);

  EXPECT_GE(outcome.hand.lowest_J, -kEnergyRounding_J);
  EXPECT_LT(outcome.hand.energy_J(), outcome.given_J);
}

TEST_F(HdapiWall, P1_GivesOutEnergyBelowIt) {
  const Outcome outcome = push(0.1, false);

  EXPECT_LT(outcome.hand.lowest_J, -outcome.given_J);
}

TEST_F(HdapiWall, P1_IsKeptFromGivingOutEnergyByThePassivityController) {
  const Outcome outcome = push(0.1, true);

  EXPECT_GT(outcome.damped, 0);
  EXPECT_GE(outcome.hand.lowest_J, -0.2 * outcome.given_J);  // the observer sees an excess one tick later
  EXPECT_LT(outcome.hand.energy_J(), outcome.given_J);
}

}  // namespace
}  // namespace torsio
