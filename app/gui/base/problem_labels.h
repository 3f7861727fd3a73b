// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

#include <QString>

namespace torsio::gui {

/// Returns problem and remedy in one line, for screens before sign-in, which have no problem panel.
[[nodiscard]] QString problemSentence(const std::exception_ptr& problem);

}  // namespace torsio::gui
