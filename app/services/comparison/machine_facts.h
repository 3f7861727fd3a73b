// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// What timings depend on besides the program; part of every result with timings.
struct MachineFacts {
  std::string processor;      ///< name from the system, or "unknown"
  int cores = 0;              ///< available to the program; 0: unknown
  double loadAverage = -1.0;  ///< over the last minute; -1: unknown
  std::string compiler;       ///< "GNU 12.2.0"
  std::string flags;          ///< those that affect speed and rounding
};

/// Reads the facts of this machine.
[[nodiscard]] MachineFacts machineFacts();

}  // namespace torsio
