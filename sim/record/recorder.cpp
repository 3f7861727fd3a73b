// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/record/recorder.h"

#include <cctype>
#include <chrono>
#include <exception>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/ids.h"
#include "sim/record/trial.h"
#include "sim/record/trial_file.h"

namespace torsio {

namespace {

// Between two looks at the ring in the recorder's own thread, and after a refusal of the sink (a database
// that restarts); the ring holds several seconds.
constexpr std::chrono::milliseconds kPeriod{20};
constexpr std::chrono::milliseconds kPeriodAfterRefusal{1000};

std::string fileNameOf(const TrialId& trialId) {
  std::string name = trialId.empty() ? "trial" : trialId;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') {
      c = '_';
    }
  }
  return name + ".torsio-trial";
}

}  // namespace

Recorder::Recorder(SpscRing<Sample>& ring, TrialSink& sink, TrialHeader header, RecorderOptions options)
    : ring_(ring),
      sink_(&sink),
      header_(std::move(header)),
      options_(std::move(options)),
      refusedBefore_(ring.refused()),
      hash_(header_) {
  TORSIO_EXPECTS(options_.samplesPerChunk >= 1 && options_.samplesPerChunk <= kLargestChunk);
  TORSIO_EXPECTS(options_.attempts >= 1);
  gathered_.reserve(static_cast<std::size_t>(options_.samplesPerChunk));
}

Recorder::~Recorder() {
  if (!thread_.joinable()) {
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    abandoned_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Recorder::start() {
  TORSIO_EXPECTS(!thread_.joinable());
  thread_ = std::thread([this] { run(); });
}

void Recorder::run() {
  for (;;) {
    pack();
    const bool accepted = deliver();
    std::unique_lock lock(mutex_);
    if (wake_.wait_for(lock, accepted ? kPeriod : kPeriodAfterRefusal, [this] { return stop_; })) {
      break;
    }
  }
  if (abandoned_) {
    return;
  }
  try {
    finishSink();
  } catch (...) {
    failure_ = std::current_exception();  // thrown again by finish(), in its caller's thread
  }
}

void Recorder::pump() {
  TORSIO_EXPECTS(!thread_.joinable());
  pack();
  (void)deliver();
}

RecordingResult Recorder::finish(TrialOutcome outcome, std::int64_t lateTicks,
                                 const std::optional<ServoHealth>& health) {
  result_.summary.health = health;
  result_.summary.outcome = outcome;
  result_.summary.lateTicks = lateTicks;
  if (!thread_.joinable()) {
    finishSink();
    return result_;
  }
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
  if (failure_) {
    std::rethrow_exception(failure_);
  }
  return result_;
}

void Recorder::pack() {
  Sample sample;
  while (ring_.pop(sample)) {
    gathered_.push_back(sample);
    taken_.fetch_add(1, std::memory_order_relaxed);
    if (static_cast<std::int64_t>(gathered_.size()) < options_.samplesPerChunk) {
      continue;
    }
    chunks_.push_back(encodeChunk(static_cast<std::int64_t>(chunks_.size()), gathered_));
    hash_.add(chunks_.back());
    gathered_.clear();
  }
}

bool Recorder::deliver() {
  try {
    if (!begun_) {
      sink_->begin(header_);
    }
    begun_ = true;
    for (; delivered_ < chunks_.size(); ++delivered_) {
      sink_->append(chunks_[delivered_]);
      failures_ = 0;
    }
    return true;
  } catch (const std::exception& refusal) {
    result_.problem = refusal.what();
    if (++failures_ >= options_.attempts && !spillSink_) {
      spill();
      return deliver();
    }
    return false;
  }
}

void Recorder::spill() {
  SpillPlace place;
  if (const auto* knowing = dynamic_cast<const SpillingTrialSink*>(sink_)) {
    place = knowing->spillPlace();
  }
  std::filesystem::path folder = place.folder.empty() ? options_.spillFolder : place.folder;
  try {
    if (folder.empty()) {
      folder = std::filesystem::temp_directory_path();
    }
    ensureFolder(folder);
  } catch (const std::exception& refusal) {
    result_.problem += "; " + std::string(refusal.what());
  }
  result_.spillFile = folder / fileNameOf(header_.trialId);
  spillSink_ = std::make_unique<TrialFileSink>(*result_.spillFile, place.context);
  sink_ = spillSink_.get();
  begun_ = false;
  delivered_ = 0;
  failures_ = 0;
  spilling_.store(true, std::memory_order_relaxed);
}

void Recorder::finishSink() {
  pack();
  if (!gathered_.empty()) {
    chunks_.push_back(encodeChunk(static_cast<std::int64_t>(chunks_.size()), gathered_));
    hash_.add(chunks_.back());
    gathered_.clear();
  }
  result_.summary.samples = taken_.load(std::memory_order_relaxed);
  result_.summary.refusedSamples = static_cast<std::int64_t>(ring_.refused() - refusedBefore_);
  result_.summary.contentHash = hash_.hex();

  for (int attempt = 1;; ++attempt) {
    try {
      if (deliver()) {
        sink_->finish(result_.summary);
        return;
      }
    } catch (const std::exception& refusal) {
      result_.problem = refusal.what();
    }
    if (attempt < options_.attempts) {
      continue;
    }
    if (spillSink_) {
      throw Error(ErrorCode::kFileUnwritable,
                  Text::verbatim("the recorded run could not be kept: %1", result_.problem),
                  result_.spillFile->string(),
                  Text::verbatim("Free some disk space and record the run again"));
    }
    spill();
    attempt = 0;
  }
}

}  // namespace torsio
