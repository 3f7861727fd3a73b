// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/unstored_trials.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/session_context.h"
#include "app/services/access/station_record.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
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
  return dataFolder() / "unstored";
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

struct TimedTrialSink::State {
  std::unique_ptr<TrialSink> sink;
  std::mutex mutex;
  std::condition_variable changed;
  Call call;  // empty: no call pending
  std::exception_ptr problem;
  bool answered = false;
  bool stop = false;
};

TimedTrialSink::TimedTrialSink(std::unique_ptr<TrialSink> sink, SpillPlace place,
                               std::chrono::milliseconds patience)
    : state_(std::make_shared<State>()), place_(std::move(place)), patience_(patience) {
  state_->sink = std::move(sink);
}

TimedTrialSink::~TimedTrialSink() {
  if (!thread_.joinable()) {
    return;
  }
  {
    const std::lock_guard lock(state_->mutex);
    state_->stop = true;
  }
  state_->changed.notify_all();
  thread_.join();
}

void TimedTrialSink::run(const std::shared_ptr<State>& state) {
  std::unique_lock lock(state->mutex);
  for (;;) {
    state->changed.wait(lock, [&] { return state->stop || state->call; });
    if (!state->call) {
      break;
    }
    const Call call = std::move(state->call);
    state->call = nullptr;
    lock.unlock();
    std::exception_ptr problem;
    try {
      call(*state->sink);
    } catch (...) {
      problem = std::current_exception();
    }
    lock.lock();
    state->problem = problem;
    state->answered = true;
    state->changed.notify_all();
  }
  lock.unlock();
  state->sink.reset();  // in the thread that opened its connection
}

void TimedTrialSink::call(Call call) {
  const auto refuse = [] {
    throw DbError(DbFault::kUnreachable, "", Text::tr("the database does not answer"), "",
                  Text::tr("The recording is kept in a file until it does"));
  };
  if (lost_) {
    refuse();
  }
  if (!thread_.joinable()) {
    thread_ = std::thread([state = state_] { run(state); });
  }
  std::unique_lock lock(state_->mutex);
  state_->call = std::move(call);
  state_->answered = false;
  state_->changed.notify_all();
  if (!state_->changed.wait_for(lock, patience_, [&] { return state_->answered; })) {
    state_->stop = true;
    lost_ = true;
    lock.unlock();
    thread_.detach();  // the thread owns the sink and ends after the pending call
    refuse();
  }
  if (state_->problem) {
    std::rethrow_exception(std::exchange(state_->problem, nullptr));
  }
}

// The arguments are copied: a call may outlive its caller.
void TimedTrialSink::begin(const TrialHeader& header) {
  call([header](TrialSink& sink) { sink.begin(header); });
}

void TimedTrialSink::append(const TrialChunk& chunk) {
  call([chunk](TrialSink& sink) { sink.append(chunk); });
}

void TimedTrialSink::finish(const TrialSummary& summary) {
  call([summary](TrialSink& sink) { sink.finish(summary); });
}

}  // namespace torsio
