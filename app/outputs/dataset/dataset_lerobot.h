// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "app/outputs/dataset/dataset.h"

namespace torsio {

/// Writes data/, meta/ and README.md of a LeRobot data set (v3.0) into `folder`: the part of writeDataset()
/// for DatasetLayout::kLerobot besides the tables. An episode per recording of the simulator; recordings of
/// other equipment have a rate of their own and no forces, and are left out. A frame per trajectory row:
/// `observation.state` is the row without its time, `action` the pose and jaw of the next row. Returns the
/// files. Throws Error{kFileUnwritable}, {kBadData} if no recording is left.
std::vector<std::filesystem::path> writeLerobot(const DatasetContents& contents,
                                                const std::filesystem::path& folder);

}  // namespace torsio
