// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

#include <QString>

namespace torsio::gui {

/// What went wrong and what to do, in one line: for the screens before the desk, which have no problem panel.
[[nodiscard]] QString problemSentence(const std::exception_ptr& problem);

}  // namespace torsio::gui
