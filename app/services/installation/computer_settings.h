// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/services/base/configuration.h"
#include "sim/core/text.h"

namespace torsio {

/// What holds at this computer for one key of its configuration.
struct ComputerSetting {
  const ConfiguredKey* key = nullptr;
  std::string value{};  ///< empty: nothing
  Text origin{};        ///< who decided, and where that is written
};

/// Returns all keys of configuration() in their order, also those that it does not set. What the centre chose
/// is in the record instead. Throws like stationRecord().
[[nodiscard]] std::vector<ComputerSetting> computerSettings();

/// Throws Error{kBadData} that names file and line where a value cannot be used: a record whose address is
/// not one, a device that Torsio does not know, a file that cannot be read. Opens no record.
void requireUsable(const Configuration& configuration);

}  // namespace torsio
