// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/base/ids.h"

class QWidget;

namespace torsio::gui {

class ShellContext;

/// Shows the deviations from the protocol that were noted in a cohort, newest first. Throws Error.
void showDeviations(ShellContext& shell, const CohortId& cohortId, QWidget* parent);

}  // namespace torsio::gui
