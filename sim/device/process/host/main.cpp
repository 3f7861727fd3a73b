// SPDX-License-Identifier: GPL-3.0-or-later
// torsio-device: the vendor's library in a process of its own. Started by Torsio, never by hand.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include "sim/base/error.h"
#include "sim/device/process/device_channel.h"

namespace torsio {
namespace {

constexpr int kLook_ms = 1;
// Time that a teardown may take when nobody waits for it any more.
constexpr auto kOrphanEnds = std::chrono::seconds(1);

/// The library's servo, between the frame and the shared memory.
struct Relay {
  DeviceChannel* channel = nullptr;
  HdapiDevice* device = nullptr;
  std::uint64_t seenForce = 0;
  std::uint32_t seenDrops = 0;

  static void tick(void* context, std::int64_t time_us) noexcept {
    auto& relay = *static_cast<Relay*>(context);
    DeviceChannel& channel = *relay.channel;
    const std::uint64_t number = channel.frames.load(std::memory_order_relaxed) + 1;
    channel.reading.publish({relay.device->read(time_us), number});
    channel.frames.store(number, std::memory_order_release);
    relay.device->enableForce(channel.forceWished.load(std::memory_order_relaxed));
    const std::uint32_t drops = channel.drops.load(std::memory_order_relaxed);
    if (drops != relay.seenDrops) {
      relay.seenDrops = drops;
      relay.device->dropForce();
    }
    const std::optional<HdapiForce> force = channel.force.latest();
    if (force && force->number != relay.seenForce) {  // one that is not renewed expires in the driver
      relay.seenForce = force->number;
      relay.device->write({force->force_N, 0});
    }
  }
};

void answer(DeviceChannel& channel, const ChannelReport& report, ChannelStage stage) {
  const std::string bytes = packed(report);
  channel.reportLength = static_cast<std::uint32_t>(std::min(bytes.size(), channel.report.size()));
  std::memcpy(channel.report.data(), bytes.data(), channel.reportLength);
  channel.stage.store(stage, std::memory_order_release);
}

bool parentGone() {
  pollfd parent{kParentFile, POLLIN, 0};
  return ::poll(&parent, 1, kLook_ms) > 0;
}

/// Ends the process although a teardown hangs.
void endOrphan(DeviceChannel& channel, HdapiDevice& device) {
  std::thread([&device] { (void)device.close(); }).detach();
  const auto until = std::chrono::steady_clock::now() + kOrphanEnds;
  channel.forceWished.store(false);
  while (std::chrono::steady_clock::now() < until && !device.released()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  channel.released.store(device.released());
}

/// Watches the library's servo and the program until one of them ends.
void watch(DeviceChannel& channel, HdapiDevice& device) {
  std::uint64_t frames = 0;
  auto lastFrame = std::chrono::steady_clock::now();
  bool letGo = false;
  while (!parentGone() && !channel.closeAsked.load()) {
    channel.snapshot.publish(device.snapshot());
    for (DeviceEvent event; device.nextEvent(event);) {
      channel.events.publish(event);
    }
    const auto now = std::chrono::steady_clock::now();
    const std::uint64_t seen = channel.frames.load(std::memory_order_acquire);
    if (seen != frames) {
      frames = seen;
      lastFrame = now;
    } else if (frames > 0 && !letGo && now - lastFrame > std::chrono::microseconds(kChildLetsGo_us)) {
      letGo = true;
      device.beginClose();  // in a thread of its own: the library hangs
    }
  }
}

int serve(DeviceChannel& channel) {
  channel.request.library.back() = '\0';
  channel.request.deviceName.back() = '\0';
  ChannelReport report;
  report.library = loadHdapi(channel.request.library.data());
  if (report.library.status != HdapiLoadStatus::kLoaded || channel.request.onlyLibrary) {
    answer(channel, report, ChannelStage::kNoLibrary);
    return 0;
  }
  HdapiOptions options;
  options.deviceName = channel.request.deviceName.data();
  options.deviceToWorld = channel.request.deviceToWorld;
  options.workspaceCentre_m = channel.request.workspaceCentre_m;
  options.stylusTip_m = channel.request.stylusTip_m;
  ChannelStage refusal = ChannelStage::kRefused;
  try {
    // Never destroyed: a library that hangs may use it until the process ends.
    auto& device = *new HdapiDevice(report.library.api, options);
    report.capabilities = device.capabilities();
    report.identity = device.identity();
    answer(channel, report, ChannelStage::kOpened);
    refusal = ChannelStage::kServoRefused;
    while (!channel.serveAsked.load() && !channel.closeAsked.load() && !parentGone()) {
    }
    auto& relay = *new Relay{&channel, &device};
    if (channel.serveAsked.load()) {
      device.start({&Relay::tick, &relay});
      channel.stage.store(ChannelStage::kServing);
      watch(channel, device);
    }
    endOrphan(channel, device);
  } catch (const Error& error) {
    report.happened = error.happenedText();
    report.remedy = error.remedyText();
    answer(channel, report, refusal);
  }
  return 0;
}

}  // namespace
}  // namespace torsio

int main() {
  // The program's end decides, not what a terminal sends to the whole group.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    std::signal(signal, SIG_IGN);
  }
  struct stat file {};
  if (fstat(torsio::kChannelFile, &file) != 0 ||
      file.st_size != static_cast<off_t>(sizeof(torsio::DeviceChannel))) {
    std::fputs("torsio-device is started by Torsio, not by hand\n", stderr);
    return 64;
  }
  void* const memory = mmap(nullptr, sizeof(torsio::DeviceChannel), PROT_READ | PROT_WRITE, MAP_SHARED,
                            torsio::kChannelFile, 0);
  if (memory == MAP_FAILED) {
    return 71;
  }
  auto& channel = *static_cast<torsio::DeviceChannel*>(memory);
  if (channel.version != torsio::kChannelVersion || channel.size != sizeof(torsio::DeviceChannel)) {
    return 65;
  }
  // Whatever hangs, the process does not outlive the program for long.
  std::thread([] {
    while (!torsio::parentGone()) {
    }
    std::this_thread::sleep_for(2 * torsio::kOrphanEnds);
    _exit(0);
  }).detach();
  // The library's own threads and exit handlers are not waited for.
  _exit(torsio::serve(channel));
}
