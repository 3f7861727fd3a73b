// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace torsio {

/// What the device process adds between a sample and the force that answers it, a value an exchange, us.
struct RelayTimes {
  std::vector<double> device_us;   ///< processor time of the device process: the whole tick of its relay
  std::vector<double> program_us;  ///< processor time of the program: taking the reading, giving the force
  std::vector<double> both_us;     ///< the sum
  std::vector<double> wall_us;     ///< from the sample to the force, both processes awake
};

/// Exchanges readings and forces between two processes over the memory that they share. Empty where there is
/// no device process.
[[nodiscard]] RelayTimes measureRelay(int exchanges);

}  // namespace torsio
