// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace torsio::gui {

/// Makes a dialog high enough for its wrapped sentences; call when one has changed. Never shrinks it.
void growToSentences(QWidget* dialog);

}  // namespace torsio::gui
