// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/record_privacy.h"

#include <system_error>

#include <QStandardPaths>

#include "db/connection/locator.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

/// Returns whether this is Torsio's default folder for records.
bool isOwnFolder(const fs::path& folder) {
  std::error_code missing;
  return fs::equivalent(
      folder, QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString(), missing);
}

}  // namespace

Text othersCouldRead(const fs::path& file) {
  return Text::tr("Other accounts of this computer could read %1; now only yours can", file.string());
}

std::vector<Text> closeRecordFiles(const std::string& locator, const fs::path& folder) {
  std::vector<Text> told;
  const auto close = [&told](const fs::path& file) {
    if (makePrivate(file)) {
      told.push_back(othersCouldRead(file));
    }
  };
  close(folder);
  const Locator place = parseLocator(locator);
  if (place.engine != Engine::kSqlite) {
    return told;
  }
  std::error_code unreadable;
  const fs::path record = fs::weakly_canonical(place.file, unreadable);  // with links resolved
  const std::string copies = record.stem().string() + "-before-restore-";
  if (isOwnFolder(record.parent_path())) {
    close(record.parent_path());
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(record.parent_path(), unreadable)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(record.filename().string()) || name.starts_with(copies)) {
      close(entry.path());
    }
  }
  return told;
}

}  // namespace torsio
