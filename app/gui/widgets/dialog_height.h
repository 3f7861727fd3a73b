// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace torsio::gui {

/// Makes a dialog high enough for its wrapped sentences at its width; call when one of them has changed. It
/// never shrinks under the hand.
void growToSentences(QWidget* dialog);

}  // namespace torsio::gui
