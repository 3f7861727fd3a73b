// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace torsio {

/// Time that the device process adds between a sample and its force, us, one value per exchange.
struct RelayTimes {
  std::vector<double> device_us;   ///< processor time of the device process: a whole tick of its relay
  std::vector<double> program_us;  ///< processor time of the program: taking the reading, giving the force
  std::vector<double> both_us;     ///< the sum
  std::vector<double> wall_us;     ///< from sample to force, with both processes awake
};

/// Exchanges readings and forces between two processes through shared memory. Empty without a device process.
[[nodiscard]] RelayTimes measureRelay(int exchanges);

}  // namespace torsio
