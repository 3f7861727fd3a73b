// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/maintenance/record_privacy.h"

#include <system_error>

#include "db/connection/locator.h"
#include "sim/base/private_files.h"

namespace torsio {

namespace fs = std::filesystem;

std::vector<Text> closeRecordFiles(const std::string& locator, const fs::path& folder) {
  std::vector<Text> told;
  const auto close = [&told](const fs::path& file) {
    if (makePrivate(file)) {
      told.push_back(
          Text::tr("Other accounts of this computer could read %1; now only yours can", file.string()));
    }
  };
  close(folder);
  const Locator place = parseLocator(locator);
  if (place.engine != Engine::kSqlite) {
    return told;
  }
  const fs::path record = fs::path(place.file);
  const std::string copies = record.stem().string() + "-before-restore-";
  std::error_code unreadable;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(record.has_parent_path() ? record.parent_path() : fs::path("."), unreadable)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(record.filename().string()) || name.starts_with(copies)) {
      close(entry.path());
    }
  }
  return told;
}

}  // namespace torsio
