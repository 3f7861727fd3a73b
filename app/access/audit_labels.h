// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sim/base/text.h"

namespace torsio {

/// What an audit entry tells of, in plain words: "Mark submitted" for "mark.submit". An action that an older
/// or newer version noted and this one does not know: its code.
[[nodiscard]] Text auditActionLabel(const std::string& action);
/// What kind of thing it was done to: "mark" for "training_mark". The same for what is not known.
[[nodiscard]] Text auditObjectLabel(const std::string& objectKind);

}  // namespace torsio
