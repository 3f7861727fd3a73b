// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// What a time depends on besides the program; stands in every result that holds times.
struct MachineFacts {
  std::string processor;       ///< as the system names it; "unknown"
  int cores = 0;               ///< that the program may use; 0: unknown
  double loadAverage = -1.0;   ///< over the last minute; -1: unknown
  std::string instructionSet;  ///< that the view's kernels use; all else is built for the plain processor
  std::string compiler;        ///< "GNU 12.2.0"
  std::string flags;           ///< that decide about speed and rounding
};

/// Reads the facts of this machine now.
[[nodiscard]] MachineFacts machineFacts();

}  // namespace torsio
