// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

/// Times of the ticks of one rod under a moving hand.
struct RodBenchResult {
  double median_us = 0.0;
  double p999_us = 0.0;
  double turn_rad = 0.0;  ///< what landmarks on the rod have turned in the end: the ticks did something
};

/// Times `ticks` >= 1 ticks of a rod of 32 nodes, 270 mm of a bent tube of radius 25 mm with G = 3 kPa,
/// pinned at both ends, by steady clock: a jaw in its middle is turned by 90 degrees about the line between
/// the ends within the ticks. Every tick is done three times from the same pose and the fastest counts: what
/// else happens on the machine does not.
[[nodiscard]] RodBenchResult runRodBench(int ticks = 3000);

}  // namespace torsio
