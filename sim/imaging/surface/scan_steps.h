// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/text.h"
#include "sim/imaging/surface/scan_surface.h"

namespace torsio {

/// What is done with a scan, in words, and where in the whole it begins and ends.
struct ScanStepShare {
  Text words;
  double from = 0.0;
  double to = 1.0;
  /// Place in the whole of a fraction of the step.
  [[nodiscard]] double at(double fraction) const noexcept { return from + (to - from) * fraction; }
};

[[nodiscard]] inline ScanStepShare shareOf(ScanStep step) {
  switch (step) {
    case ScanStep::kReading:
      return {Text::tr("Reading the scan"), 0.0, 0.3};
    case ScanStep::kSegmenting:
      return {Text::tr("Looking for the organ"), 0.3, 0.5};
    case ScanStep::kDrawing:
      return {Text::tr("Drawing its surface"), 0.5, 0.7};
    case ScanStep::kThinning:
      return {Text::tr("Smoothing and thinning"), 0.7, 0.9};
    case ScanStep::kMeasuring:
      break;
  }
  return {Text::tr("Measuring the wall"), 0.9, 1.0};
}

}  // namespace torsio
