// SPDX-License-Identifier: GPL-3.0-or-later
// A trial replays by the rules it was recorded with. The digests are those of the program that recorded by
// rules 1 to 3, for a hand whose device stands still, is lost or delivers invalid poses now and then.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/record/sample_codec.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {
namespace {

/// To and fro through the surface of the bar, 10 mm in 100 ms and back, its jaw at work; no library's sine.
class PacedHand final : public HapticDevice {
 public:
  PacedHand(std::uint32_t status, std::int64_t every, std::int64_t lasts)
      : status_(status), every_(every), lasts_(lasts) {
    capabilities_.rendersForce = true;
  }
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override {
    const std::int64_t tick = time_us / 1000;
    const std::int64_t along = tick % 200 < 100 ? tick % 200 : 200 - tick % 200;
    const bool repeats = tick % every_ >= every_ - lasts_;
    if (!repeats) {
      reading_.pose.position_m = {kBarRadius_m + 0.006 - 1e-4 * static_cast<double>(along),
                                  1e-5 * static_cast<double>(tick % 700), 0.2};
      reading_.pose.orientation = {0.70710678118654752, 0.0, 0.70710678118654752, 0.0};
      reading_.grip = (tick / 150) % 2 == 1 ? 1.0 : 0.0;
      reading_.buttons = reading_.grip > 0.0 ? static_cast<std::uint32_t>(kButtonGrip) : 0U;
    }
    reading_.time_us = time_us;
    reading_.status = repeats ? status_ : static_cast<std::uint32_t>(kDeviceOk);
    last_ = quantize(reading_, last_);
    return last_;
  }
  void write(const ForceCommand& /*command*/) noexcept override {}

 private:
  DeviceCapabilities capabilities_;
  std::uint32_t status_;
  std::int64_t every_;
  std::int64_t lasts_;
  DeviceReading reading_;
  DeviceSample last_;
};

std::string answersOf(const Scene& scene, std::uint32_t rules, PacedHand hand) {
  ServoLoop loop({.device = &hand, .scene = &scene}, {.rules = rules, .seed = 7});
  std::vector<Sample> samples;
  for (int tick = 0; tick < 3'000; ++tick) {
    loop.tick(1000LL * tick);
    samples.push_back(loop.lastSample());
  }
  return outputDigest(samples);
}

TEST(EarlierRules, AnswerBitForBitAsTheyDid) {
  const Scene bar = barScene();
  const Scene tube = hollowScene(twistedTube());
  struct Case {
    const Scene* scene;
    std::uint32_t rules;
    PacedHand hand;
    const char* digest;
  };
  const PacedHand ticks(kDeviceStale, 7, 2);
  const PacedHand stands(kDeviceStale, 360, 90);
  const PacedHand lost(kDeviceLost, 360, 90);
  const PacedHand invalid(kDeviceInvalid, 1'100, 3);
  for (const Case& one : {
           Case{&bar, 1, ticks, "994e251f930edd5e4e5e69b654696c9383b3545808fe48d3c58925067e4f1090"},
           Case{&bar, 1, stands, "0299c896de410ae45bce7210c14ccdd40b95be96f8f6083bc064a1762c236e4a"},
           Case{&bar, 2, ticks, "8cc793bf98159fb5aae6be49256fb50592b27c7bb275d284f336948a0f9951fa"},
           Case{&bar, 2, stands, "796283df5a9ba8ec726e55194df52262465ffef0d34141abce6e882533878d9e"},
           Case{&bar, 2, lost, "e20282e2c736b15f010b9ba183f53634c594c57b0e9f7fb50bac57cda1f61ba5"},
           Case{&bar, 2, invalid, "3079eb01dc16ee9c388882bfd3b2eb7571f620c7d1fe7a47e086b848ededead2"},
           Case{&tube, 3, ticks, "e64cdf450878ac0df9bda9ec55d981a64bd5acb88ef9126b244cdc26223170f5"},
           Case{&tube, 3, stands, "7f7c2561a8c284314cba13a21e0da651d3fc7247258a1de69c3433b17fcb6f69"},
       }) {
    EXPECT_EQ(answersOf(*one.scene, one.rules, one.hand), one.digest) << "rules " << one.rules;
  }
}

}  // namespace
}  // namespace torsio
