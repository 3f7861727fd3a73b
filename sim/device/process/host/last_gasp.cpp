// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/process/host/last_gasp.h"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <semaphore.h>
#include <sys/mman.h>
#include <thread>

#include "sim/core/deadline.h"

namespace torsio {

namespace {

// How long an end waits for the library, in looks of 0.2 ms: 20 ms.
constexpr int kLooks = 100;
constexpr timespec kLook{0, 200'000};
constexpr std::size_t kStack_bytes = 64 * 1024;

sem_t wanted;
std::atomic<bool> armed{false};
std::atomic<bool> done{false};

/// Any thread, in a signal as well.
void lastGasp() noexcept {
  if (!armed.load()) {
    return;
  }
  sem_post(&wanted);
  for (int i = 0; i < kLooks && !done.load(); ++i) {
    nanosleep(&kLook, nullptr);
  }
}

/// The signal has its usual meaning again when this returns.
void ended(int signal) {
  lastGasp();
  (void)std::raise(signal);
}

bool isHeard(int signal) {
  switch (signal) {
    case SIGKILL:  // nobody hears these two
    case SIGSTOP:
    case SIGCHLD:  // these end nothing
    case SIGCONT:
    case SIGURG:
    case SIGWINCH:
      return false;
    default: {
      struct sigaction now {};
      // What the process ignores, and what a library took for itself.
      return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL;
    }
  }
}

}  // namespace

void useSignalStack() noexcept {
  stack_t now{};
  if (sigaltstack(nullptr, &now) != 0 || (now.ss_flags & SS_DISABLE) == 0) {
    return;
  }
  void* const place =
      mmap(nullptr, kStack_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK, -1, 0);
  if (place != MAP_FAILED) {
    now.ss_sp = place;
    now.ss_size = kStack_bytes;
    now.ss_flags = 0;
    (void)sigaltstack(&now, nullptr);
  }
}

void armLastGasp(HostedDevice& device, DeviceChannel& channel) {
  sem_init(&wanted, 0, 0);
  std::thread([&device, &channel] {
    (void)requestRealTime(RealTimeRank::kWatchdog);
    useSignalStack();
    while (sem_wait(&wanted) != 0) {
    }
    channel.forceWished.store(false);
    device.switchOff();
    done.store(true);
  }).detach();
  armed.store(true);
  useSignalStack();
  // Before what the library registered when it was loaded.
  std::atexit(lastGasp);
  std::at_quick_exit(lastGasp);
  std::set_terminate([] {
    lastGasp();
    std::abort();
  });
  for (int signal = 1; signal <= SIGRTMAX; ++signal) {
    if (isHeard(signal)) {
      struct sigaction action {};
      action.sa_handler = ended;
      action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);
      (void)sigaction(signal, &action, nullptr);
    }
  }
}

}  // namespace torsio
