// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/trial_store.h"

#include <filesystem>

#include <QStandardPaths>

#include "app/access/session_context.h"
#include "sim/base/file_io.h"

namespace torsio {

std::string defaultDatabase() {
  const std::filesystem::path folder =
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString();
  ensureFolder(folder);
  return (folder / "torsio.sqlite").string();
}

TrialStore::TrialStore(const std::string& locator) : connection_(openUpToDate(locator)) {}

std::vector<TrialListing> TrialStore::list() {
  return TrialRepository(connection_).list();
}

Trial TrialStore::load(const std::string& trialId) {
  return TrialRepository(connection_).load(trialId);
}

}  // namespace torsio
