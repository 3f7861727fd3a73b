// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace torsio::gui {

/// Version and build, licence, and what Torsio is not: a medical device, a place for patient data.
[[nodiscard]] QString aboutText();
void showAboutBox(QWidget* parent);

}  // namespace torsio::gui
