// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/xapi/lrs_worker.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>

#include "app/connectors/xapi/lrs_client.h"
#include "app/connectors/xapi/lrs_delivery.h"
#include "app/connectors/xapi/lrs_settings.h"
#include "db/connection/connection.h"

namespace torsio {

struct LrsWorker::State {
  State(SessionKey station, std::chrono::milliseconds wait) : key(std::move(station)), again(wait) {}

  SessionKey key;
  std::chrono::milliseconds again;
  std::atomic<bool> stop{false};
  std::mutex mutex{};
  std::condition_variable wake{};
};

LrsWorker::LrsWorker(SessionKey key, std::chrono::milliseconds again)
    : state_(std::make_unique<State>(std::move(key), again)), thread_([this] { run(*state_); }) {}

LrsWorker::~LrsWorker() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stop = true;
  }
  state_->wake.notify_all();
  thread_.join();
}

void LrsWorker::run(State& state) {
  std::unique_lock lock(state.mutex);
  while (!state.wake.wait_for(lock, state.again, [&] { return state.stop.load(); })) {
    lock.unlock();
    try {
      if (const std::optional<LrsKey> key = stationLrsKey()) {
        SessionContext session(state.key);
        Connection& connection = session.connectionWithoutRight();
        const std::optional<LrsIdentity> identity = lrsIdentity(connection);
        if (identity && identity->settings.on) {
          LrsClient store(identity->settings.endpoint, *key, std::chrono::seconds(30), &state.stop);
          (void)deliverLearningRecords(connection, *identity, store, [&] { return session.now_us(); });
        }
      }
    } catch (const std::exception&) {
      // The database or the key file is unavailable: entries stay in the outbox for the next try.
    }
    lock.lock();
  }
}

}  // namespace torsio
