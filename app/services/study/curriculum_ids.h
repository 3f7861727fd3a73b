// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/domain/study/curriculum.h"

namespace torsio {

class IdSource;

/// Returns a stored version as a draft: modules, arms and phases carry their codes in place of ids.
[[nodiscard]] CurriculumVersion withCodes(CurriculumVersion version);
/// Returns a draft with new ids in place of codes, taken from `ids` for the modules, then for each arm and
/// its phases. Throws std::out_of_range for a code that no module has: a draft is checked before it is
/// stored.
[[nodiscard]] CurriculumVersion withIds(CurriculumVersion draft, IdSource& ids);

}  // namespace torsio
