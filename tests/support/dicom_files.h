// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "sim/imaging/scan/scan_volume.h"

class DcmDataset;

namespace torsio::testing {

/// Format of a series.
struct DicomStyle {
  std::string syntax = "plain";  ///< plain, deflated, big-endian, rle, jpeg, jpeg-ls, implicit
  double slope = 1.0;
  double intercept = -1024.0;
  bool isSigned = false;
  std::string modality = "CT";
  std::string series = "1.2.3.4";
  std::string names = "slice";  ///< prefix of the file names
  /// Called with each slice before it is written.
  std::function<void(DcmDataset&, std::size_t slice)> change = nullptr;
};

/// Writes each layer of a volume along z into a file of a folder, with a patient's name (Doe^Jane, PID4711).
/// For `tests/sim/imaging` and the benchmark.
void writeDicomSeries(const std::filesystem::path& folder, const ScanVolume& scan,
                      const DicomStyle& style = {});

}  // namespace torsio::testing
