// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "app/outputs/dataset/dataset.h"

namespace torsio {

/// Writes the BIDS description files and recordings (sub-*/motion) into `folder`: the part of writeDataset()
/// for DatasetLayout::kBids besides the tables. Returns the files. Throws Error{kFileUnwritable}.
std::vector<std::filesystem::path> writeBids(const DatasetContents& contents,
                                             const std::filesystem::path& folder);

}  // namespace torsio
