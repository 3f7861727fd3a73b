// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/session/study/allocation_service.h"

namespace torsio::gui {

/// A PDF to print on A4: in each strip on the left the label of an envelope (whose it is), on the right the
/// card that goes into it (the group). Throws Error{kFileUnwritable}.
void writeSealedCards(const std::vector<SealedCard>& cards, const std::string& cohort,
                      const std::filesystem::path& file);

}  // namespace torsio::gui
