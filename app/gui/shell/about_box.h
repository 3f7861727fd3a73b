// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace torsio::gui {

/// Version, build, licence, and the disclaimers: not a medical device, not for patient data.
[[nodiscard]] QString aboutText();
void showAboutBox(QWidget* parent);

}  // namespace torsio::gui
