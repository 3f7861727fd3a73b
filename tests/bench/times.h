// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

namespace torsio {

/// Processor time of this thread, in ns resolution where the system has it.
inline double processor_us() {
#ifdef CLOCK_THREAD_CPUTIME_ID
  std::timespec spent{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
  return 1e6 * static_cast<double>(spent.tv_sec) + 1e-3 * static_cast<double>(spent.tv_nsec);
#else
  return static_cast<double>(std::clock()) * (1e6 / CLOCKS_PER_SEC);
#endif
}

inline double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

/// Median time by the clock `now_us()` of a[i] = b[i] + s c[i] over this many doubles.
template <typename Clock>
double triad_us(std::size_t doubles, std::size_t repeats, const Clock& now_us) {
  std::vector<double> a(doubles, 0.0);
  const std::vector<double> b(doubles, 1.0);
  const std::vector<double> c(doubles, 2.0);
  std::vector<double> times_us;
  double scale = 0.5;
  for (std::size_t repeat = 0; repeat < repeats; ++repeat) {
    const double begun_us = now_us();
    for (std::size_t i = 0; i < doubles; ++i) {
      a[i] = b[i] + scale * c[i];
    }
    times_us.push_back(now_us() - begun_us);
    scale = a[repeat] * 0.25;  // each pass depends on the previous one
  }
  std::sort(times_us.begin(), times_us.end());
  return quantile(times_us, 0.5);
}

}  // namespace torsio
