// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "app/session/access/workplace.h"

namespace torsio {

/// The choices of the centre, the same for all its stations, by name. Services read the one that they need
/// themselves. kSettingsEdit.
[[nodiscard]] std::map<std::string, std::string> centreSettings(Workplace& workplace);
/// Audited with the old and the new value. kSettingsEdit. Throws Error{kBadParameter} for a name that is not
/// made of lower-case letters, digits and underscores, or a value that is too long.
void setCentreSetting(Workplace& workplace, const std::string& name, const std::string& value,
                      const std::string& reason = {});

}  // namespace torsio
