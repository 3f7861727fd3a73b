// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <sstream>
#include <string>

namespace torsio::testing {

/// What something costs this program from here on, in time and in memory at its peak (Linux).
class Cost {
 public:
  Cost() {
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak begins anew
    before_bytes_ = status_bytes("VmRSS:");
  }
  [[nodiscard]] double time_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  [[nodiscard]] std::int64_t memory_bytes() const { return status_bytes("VmHWM:") - before_bytes_; }

 private:
  [[nodiscard]] static std::int64_t status_bytes(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with(name)) {
        return std::stoll(line.substr(name.size())) * 1024;
      }
    }
    return 0;
  }

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::int64_t before_bytes_ = 0;
};

inline std::ostream& operator<<(std::ostream& out, const Cost& cost) {
  constexpr double kMegabyte = 1e6;
  std::ostringstream words;
  words.precision(2);
  words << std::fixed << cost.time_s() << " s, " << static_cast<double>(cost.memory_bytes()) / kMegabyte
        << " MB";
  return out << words.str();
}

}  // namespace torsio::testing
