// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

class QImage;

namespace torsio::gui {

/// Writes a picture as PNG, completely or not at all. Throws Error{kDevice} for an empty picture (a display
/// that cannot draw the scene) and Error{kFileUnwritable}.
void writePicture(const QImage& picture, const std::filesystem::path& file);

}  // namespace torsio::gui
