// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/relay_bench.h"

#include <atomic>
#include <cstdint>
#include <new>
#include <optional>

#ifdef __linux__
#include <csignal>
#include <ctime>
#include <sched.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/core/contracts.h"
#include "sim/core/deadline.h"
#include "sim/device/process/device_channel.h"
#endif

namespace torsio {

#ifdef __linux__

namespace {

double processorNow_us() {
  timespec spent{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
  return 1e6 * static_cast<double>(spent.tv_sec) + 1e-3 * static_cast<double>(spent.tv_nsec);
}

/// A driver without effect, to measure only the relay.
class NoDriver final : public HapticDevice {
 public:
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override { return {.time_us = time_us}; }
  void write(const ForceCommand& command) noexcept override { taken_N = command.force_N.x; }

  double taken_N = 0.0;

 private:
  DeviceCapabilities capabilities_;
};

/// Memory shared by both processes.
struct Shared {
  DeviceChannel channel;
  std::atomic<double> device_us{0.0};  // of the exchange that the device process has just completed
  std::atomic<double> wall_us{0.0};
  std::atomic<std::int64_t> finished{0};
};

/// Runs the device process: one tick per exchange, which sends a sample and receives the previous force.
[[noreturn]] void runDevice(Shared& shared) {
  NoDriver driver;
  DeviceRelay relay{&shared.channel, &driver};
  for (std::int64_t number = 1;; ++number) {
    const std::int64_t begun_ns = deadlineNow_ns();
    const double before_us = processorNow_us();
    relay.tick(number);
    const double spent_us = processorNow_us() - before_us;
    // The next force answers this sample; a servo would find it in its next frame.
    for (;;) {
      const std::optional<MailedForce> force = shared.channel.force.latest();
      if (force && force->number == static_cast<std::uint64_t>(number)) {
        break;
      }
      sched_yield();
    }
    shared.wall_us = 1e-3 * static_cast<double>(deadlineNow_ns() - begun_ns);
    shared.device_us = spent_us;
    shared.finished = number;
  }
}

}  // namespace

RelayTimes measureRelay(int exchanges) {
  void* const place =
      mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  TORSIO_EXPECTS(place != MAP_FAILED);
  auto& shared = *new (place) Shared;
  const pid_t device = fork();
  if (device == 0) {
    runDevice(shared);
  }
  RelayTimes times;
  for (int number = 1; number <= exchanges; ++number) {
    double spent_us = 0.0;
    for (bool answered = false; !answered;) {
      const double before_us = processorNow_us();
      const std::optional<MailedReading> reading = shared.channel.reading.latest();
      answered = reading && reading->number == static_cast<std::uint64_t>(number);
      if (answered) {
        shared.channel.force.publish({{1.0, 0.0, 0.0}, reading->number});
        spent_us = processorNow_us() - before_us;
      } else {
        sched_yield();
      }
    }
    while (shared.finished < number) {
      sched_yield();
    }
    times.program_us.push_back(spent_us);
    times.device_us.push_back(shared.device_us);
    times.both_us.push_back(spent_us + shared.device_us);
    times.wall_us.push_back(shared.wall_us);
  }
  kill(device, SIGKILL);
  waitpid(device, nullptr, 0);
  munmap(place, sizeof(Shared));
  return times;
}

#else

RelayTimes measureRelay(int) {
  return {};
}

#endif

}  // namespace torsio
