// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/timed_sink.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

#include "db/connection/db_error.h"

namespace torsio {

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
