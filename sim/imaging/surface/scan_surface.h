// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "sim/imaging/surface/scan_request.h"

namespace torsio {

/// What is being done with a scan.
enum class ScanStep { kReading, kSegmenting, kDrawing, kThinning, kMeasuring };

/// Told what is done now and how much of it, 0..1.
using ScanProgress = std::function<void(ScanStep step, double fraction)>;

/// Reads a scan, finds the organ in it and draws its surface: closed, smoothed, about kKeptTriangles. Not yet
/// checked as an organ. In this process: files of users are read by scanApart(). Throws Error{kFileMissing,
/// kFileUnreadable} with the code of the rule (D01 to D18, N01 to N07), {kBadParameter} for a request out of
/// range.
[[nodiscard]] ScanSurface surfaceOfScan(const ScanRequest& request, const ScanProgress& progress = {});

/// Finds the organ in a scan that was read already and draws its surface, as surfaceOfScan(request); `where`
/// names the scan.
[[nodiscard]] ScanSurface surfaceOfScan(ScanRead scan, const ScanRequest& request, const std::string& where,
                                        const ScanProgress& progress = {});

}  // namespace torsio
