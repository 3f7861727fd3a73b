// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/trial_store.h"

#include <filesystem>

#include <QStandardPaths>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/file_io.h"

namespace torsio {

std::string defaultDatabase() {
  const std::filesystem::path folder =
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString();
  ensureFolder(folder);
  return (folder / "torsio.sqlite").string();
}

TrialStore::TrialStore(const std::string& locator)
    : connection_(std::make_unique<Connection>(openUpToDate(locator))) {}

TrialStore::~TrialStore() = default;

const std::string& TrialStore::location() const noexcept {
  return connection_->location();
}

std::vector<TrialListing> TrialStore::list() {
  return TrialRepository(*connection_).list();
}

Trial TrialStore::load(const TrialId& trialId) {
  return TrialRepository(*connection_).load(trialId);
}

}  // namespace torsio
