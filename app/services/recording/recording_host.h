// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "assessment/attempt/trial_listing.h"

namespace torsio {

/// Describes the present machine for the trials that it records: name, operating system, processor with its
/// number of threads, graphics card. What the system does not tell stays empty (the graphics card is told by
/// Linux only). `root`: where the files of the system begin.
[[nodiscard]] RecordingHost thisHost(const std::filesystem::path& root = "/");

/// Returns the context of a recording of free practice: this station and this machine, nobody's training.
[[nodiscard]] TrialContext stationContext();

}  // namespace torsio
