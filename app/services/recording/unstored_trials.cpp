// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/unstored_trials.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include <QStandardPaths>
#include <nlohmann/json.hpp>

#include "app/services/access/session_context.h"
#include "app/services/recording/timed_sink.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/record/trial_file.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kTrialFile = ".torsio-trial";

/// Returns one name per database, whoever signs in to the server and whatever the working directory.
std::string databaseName(const std::string& locator) {
  const Locator where = parseLocator(locator);
  if (where.engine == Engine::kSqlite) {
    return fs::weakly_canonical(where.file).string();
  }
  return where.shown();
}

std::string textOf(const std::string& locator, const TrialContext& context) {
  const json text{{"database", databaseName(locator)},
                  {"station", context.station},
                  {"enrolment", context.enrolmentId},
                  {"module", context.moduleId},
                  {"phase", context.phaseId},
                  {"mode", context.attemptMode ? storedText(*context.attemptMode) : ""},
                  {"host_name", context.host.name},
                  {"host_os", context.host.os},
                  {"host_cpu", context.host.cpu},
                  {"host_gpu", context.host.gpu}};
  return text.dump(-1, ' ', false, json::error_handler_t::replace);
}

TrialContext contextOf(const json& text) {
  const auto of = [&text](const char* key) { return text.value(key, std::string()); };
  return {
      .station = of("station"),
      .enrolmentId = of("enrolment"),
      .moduleId = of("module"),
      .phaseId = of("phase"),
      .attemptMode = fromStoredText<AttemptMode>(of("mode")),
      .host = {.name = of("host_name"), .os = of("host_os"), .cpu = of("host_cpu"), .gpu = of("host_gpu")}};
}

bool endsWith(const std::string& name, const std::string& ending) {
  return name.size() >= ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

bool isWaiting(const fs::path& file) {
  const std::string name = file.filename().string();
  if (endsWith(name, kTrialFile)) {
    return true;
  }
  if (!endsWith(name, temporaryBeside(kTrialFile).string())) {
    return false;
  }
  std::error_code gone;
  const fs::file_time_type written = fs::last_write_time(file, gone);
  return !gone && fs::file_time_type::clock::now() - written > std::chrono::microseconds(kQuietFile_us);
}

std::optional<UnstoredTrial> readFor(const std::string& database, const fs::path& file) {
  TrialFile read = openTrialFile(file);
  const json text = json::parse(read.context, nullptr, false);
  if (!text.is_object() || text.value("database", std::string()) != database) {
    return std::nullopt;
  }
  return UnstoredTrial{file, std::move(read.trial), contextOf(text)};
}

}  // namespace

fs::path unstoredFolder() {
  return fs::path(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString()) /
         "unstored";
}

std::unique_ptr<TrialSink> recordingSink(const std::string& locator, const TrialContext& context,
                                         const fs::path& folder) {
  return std::make_unique<TimedTrialSink>(std::make_unique<OwnConnectionTrialSink>(locator, context),
                                          SpillPlace{folder, textOf(locator, context)});
}

UnstoredTrials unstoredTrials(const std::string& locator, const fs::path& folder) {
  UnstoredTrials found;
  const std::string database = databaseName(locator);
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
    if (!entry.is_regular_file() || !isWaiting(entry.path())) {
      continue;
    }
    try {
      std::optional<UnstoredTrial> trial = readFor(database, entry.path());
      if (trial) {
        found.trials.push_back(std::move(*trial));
      }
    } catch (const std::exception& problem) {
      found.unreadable.push_back(
          Text::tr("A saved recording cannot be read and stays where it is: %1", problem.what()));
    }
  }
  std::sort(found.trials.begin(), found.trials.end(), [](const UnstoredTrial& a, const UnstoredTrial& b) {
    return std::pair(a.trial.header.startedUtc_us, a.file) < std::pair(b.trial.header.startedUtc_us, b.file);
  });
  return found;
}

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
