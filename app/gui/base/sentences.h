// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/outputs/wording/joined_sentences.h"

namespace torsio::gui {

/// Pages join sentences like reports.
using torsio::joinedSentences;

}  // namespace torsio::gui
