// SPDX-License-Identifier: GPL-3.0-or-later
// torsio-device: the driver of a device that renders force, in a process of its own. Started by Torsio, never
// by hand.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <poll.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include "sim/core/deadline.h"
#include "sim/core/error.h"
#include "sim/device/hdapi/hdapi_device.h"
#include "sim/device/inverse3/inverse3_device.h"
#include "sim/device/process/device_channel.h"
#include "sim/device/process/host/last_gasp.h"

namespace torsio {
namespace {

constexpr int kLook_ms = 1;
// Longest teardown after the program has gone.
constexpr auto kOrphanEnds = std::chrono::seconds(1);
// Looks in a row without a frame before the driver counts as silent: a machine that stalls both does not
// count.
constexpr int kLooksForgiven = 10;

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

/// Ends the process and what a library started in it.
[[noreturn]] void endGroup(int code) {
  if (getpgrp() == getpid()) {
    (void)kill(0, SIGKILL);
  }
  _exit(code);
}

/// Lets go of the device although a teardown hangs.
void endOrphan(DeviceChannel& channel, HostedDevice& device) {
  std::thread([&device] { (void)device.close(); }).detach();
  const auto until = std::chrono::steady_clock::now() + kOrphanEnds;
  channel.forceWished.store(false);
  while (std::chrono::steady_clock::now() < until && !device.released()) {
    channel.silent.store(device.silent());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  channel.silent.store(device.silent());
  channel.released.store(device.released());
}

/// Watches the driver's servo and the program until one of them ends. Goes before the servo where the system
/// permits it.
void watch(DeviceChannel& channel, HostedDevice& device) {
  (void)requestRealTime(RealTimeRank::kWatchdog);
  std::uint64_t frames = 0;
  int still = 0;
  auto lastFrame = std::chrono::steady_clock::now();
  bool letGo = false;
  while (!parentGone() && !channel.closeAsked.load()) {
    const DeviceSnapshot snapshot = device.snapshot();
    channel.snapshot.publish(snapshot);
    for (DeviceEvent event; device.nextEvent(event);) {
      channel.events.publish(event);
    }
    const auto now = std::chrono::steady_clock::now();
    const std::uint64_t seen = channel.frames.load(std::memory_order_acquire);
    if (seen != frames) {
      frames = seen;
      lastFrame = now;
      still = 0;
    } else if (++still >= kLooksForgiven && frames > 0 && !letGo && snapshot.state != DeviceState::kLost &&
               now - lastFrame > std::chrono::microseconds(kChildLetsGo_us)) {
      letGo = true;
      device.beginClose();  // in a thread of its own: the driver hangs
    }
  }
}

/// Opens what is asked for; null when there is nothing to open and the report says why. Throws
/// Error{kDevice}.
std::unique_ptr<HostedDevice> openStylusHere(const ChannelRequest& asked, ChannelReport& report) {
  report.library = loadHdapi(asked.library.data());
  if (report.library.status != HdapiLoadStatus::kLoaded || asked.onlyLook) {
    return nullptr;
  }
  HdapiOptions options;
  options.deviceName = asked.deviceName.data();
  options.deviceToWorld = asked.deviceToWorld;
  options.workspaceCentre_m = asked.workspaceCentre_m;
  options.stylusTip_m = asked.stylusTip_m;
  return std::make_unique<HdapiDevice>(report.library.api, options);
}

std::unique_ptr<HostedDevice> openHere(const ChannelRequest& asked, ChannelReport& report) {
  if (inverse3Driver().id != asked.driver.data()) {
    return openStylusHere(asked, report);
  }
  DeviceRequest request;
  request.name = asked.deviceName.data();
  request.workspaceCentre_m = asked.workspaceCentre_m;
  if (asked.onlyLook) {
    report.finding = inverse3Driver().look(request);
    return nullptr;
  }
  return openInverse3(request);
}

/// The relay's tick, whose thread is heard even when it runs out of its stack.
struct HeardTick {
  DeviceRelay relay;
  bool prepared = false;

  static void run(void* context, std::int64_t time_us) {
    HeardTick& self = *static_cast<HeardTick*>(context);
    if (!std::exchange(self.prepared, true)) {
      useSignalStack();
    }
    self.relay.tick(time_us);
  }
};

/// Lets frames without a force pass, so that the device has its zero.
/// Returns whether the device took a frame without force.
bool sendZero(DeviceChannel& channel) {
  constexpr std::uint64_t kFrames = 3;
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
  while (channel.frames.load() < kFrames && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return channel.frames.load() > 0;
}

int serve(DeviceChannel& channel) {
  channel.request.driver.back() = '\0';
  channel.request.library.back() = '\0';
  channel.request.deviceName.back() = '\0';
  ChannelReport report;
  ChannelStage refusal = ChannelStage::kRefused;
  try {
    std::unique_ptr<HostedDevice> opened = openHere(channel.request, report);
    if (opened == nullptr) {
      answer(channel, report, ChannelStage::kLooked);
      return 0;
    }
    // Never destroyed: a driver that hangs may use it until the process ends.
    HostedDevice& device = *opened.release();
    report.capabilities = device.capabilities();
    report.identity = device.identity();
    auto& tick = *new HeardTick{{&channel, &device}};
    if (channel.request.onlyLetGo) {
      device.start({HeardTick::run, &tick});
      if (!sendZero(channel)) {
        throw Error(ErrorCode::kDevice,
                    Text::tr("the second connection was not called by the device's servo"), "", "");
      }
      channel.stage.store(ChannelStage::kServing);
      endOrphan(channel, device);
      return 0;
    }
    answer(channel, report, ChannelStage::kOpened);
    refusal = ChannelStage::kServoRefused;
    while (!channel.serveAsked.load() && !channel.closeAsked.load() && !parentGone()) {
    }
    if (channel.serveAsked.load()) {
      device.start({HeardTick::run, &tick});
      armLastGasp(device, channel);
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
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGTSTP, SIGTTIN, SIGTTOU}) {
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
    torsio::endGroup(0);
  }).detach();
  // A library's own threads and exit handlers are not waited for.
  torsio::endGroup(torsio::serve(channel));
}
