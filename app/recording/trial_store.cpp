// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/trial_store.h"

#include <filesystem>
#include <utility>

#include <QStandardPaths>

#include "app/access/session_context.h"
#include "app/recording/recording_host.h"
#include "app/recording/unstored_trials.h"
#include "assessment/attempt/trial_listing.h"
#include "db/connection/connection.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/base/file_io.h"

namespace torsio {

std::string defaultDatabase() {
  const std::filesystem::path folder =
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString();
  ensureFolder(folder);
  return (folder / "torsio.sqlite").string();
}

TrialStore::TrialStore(std::string locator)
    : locator_(std::move(locator)), connection_(std::make_unique<Connection>(openUpToDate(locator_))) {}

TrialStore::~TrialStore() = default;

const std::string& TrialStore::location() const noexcept {
  return connection_->location();
}

std::unique_ptr<TrialSink> TrialStore::newSink() const {
  return recordingSink(locator_, {.station = stationName(), .host = thisHost()});
}

std::vector<TrialListing> TrialStore::list() {
  return TrialRepository(*connection_).list();
}

Trial TrialStore::load(const std::string& trialId) {
  return TrialRepository(*connection_).load(trialId);
}

}  // namespace torsio
