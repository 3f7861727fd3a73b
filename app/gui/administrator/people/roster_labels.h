// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "app/services/people/roster_import.h"
#include "sim/core/error.h"

namespace torsio::gui {

/// Names a field of a roster in the user's language.
[[nodiscard]] QString rosterFieldName(RosterField field);
/// Names the effect on a line, with its sign: "+ new".
[[nodiscard]] QString rosterStatusName(RosterStatus status);
/// Returns the note for a line: its error, changes or peculiarities.
[[nodiscard]] QString rosterNote(const RosterRow& row);
/// Returns error and remedy in sentences.
[[nodiscard]] QString rosterProblem(const Error& error);

}  // namespace torsio::gui
