// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/assets.h"

#include <array>
#include <cstdlib>
#include <system_error>

#include <QCoreApplication>

#include "sim/core/error.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

bool holdsScenes(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder / "scenes", ignored);
}

}  // namespace

fs::path assetsFolder() {
  if (const char* chosen = std::getenv("TORSIO_ASSETS"); chosen != nullptr) {
    if (holdsScenes(chosen)) {
      return chosen;
    }
    throw Error(ErrorCode::kFileMissing, Text::tr("no folder 'scenes' in it"),
                Text::verbatim("TORSIO_ASSETS=%1", chosen),
                Text::tr("Point TORSIO_ASSETS at the assets folder, or unset it"));
  }
  std::array<fs::path, 2> candidates{fs::path(), fs::path(TORSIO_SOURCE_ASSETS)};
  if (QCoreApplication::instance() != nullptr) {
    candidates[0] =
        fs::path(QCoreApplication::applicationDirPath().toStdString()) / ".." / "share" / "torsio" / "assets";
  }
  for (const fs::path& folder : candidates) {
    if (!folder.empty() && holdsScenes(folder)) {
      return fs::weakly_canonical(folder);
    }
  }
  throw Error(ErrorCode::kFileMissing, Text::tr("organs and scenes are not installed"),
              std::string(TORSIO_SOURCE_ASSETS), Text::tr("Set TORSIO_ASSETS to the assets folder"));
}

}  // namespace torsio
