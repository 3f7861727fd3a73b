// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdlib>
#include <sched.h>
#include <utility>

#include "sim/tissue/twist/twist_bench_platform.h"

namespace torsio {

#if defined(__linux__)
struct CorePin::Saved {
  cpu_set_t cores;
};

CorePin::CorePin() {
  auto saved = std::make_unique<Saved>();
  if (sched_getaffinity(0, sizeof saved->cores, &saved->cores) != 0) {
    return;
  }
  const int here = sched_getcpu();
  if (here < 0) {
    return;
  }
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(here), &one);
  if (sched_setaffinity(0, sizeof one, &one) != 0) {
    return;
  }
  core_ = here;
  saved_ = std::move(saved);
}

CorePin::~CorePin() {
  if (saved_) {
    sched_setaffinity(0, sizeof saved_->cores, &saved_->cores);
  }
}
#else
struct CorePin::Saved {};
CorePin::CorePin() = default;
CorePin::~CorePin() = default;
#endif

double loadAverage() {
  double average = -1.0;
  return getloadavg(&average, 1) == 1 ? average : -1.0;
}

}  // namespace torsio
