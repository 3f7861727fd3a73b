// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "sim/core/spsc_ring.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial.h"

namespace torsio {

/// Samples that the ring between servo and recorder should hold: a disk may be slow for eight seconds.
inline constexpr std::size_t kRecordingRing = 8'192;

struct RecorderOptions {
  std::int64_t samplesPerChunk = kSamplesPerChunk;
  int attempts = 3;  ///< how often the sink may fail in a row before the trial goes to a file instead
  /// Folder for trials that their sink refused; made when needed. Empty: the system's temporary folder.
  std::filesystem::path spillFolder;
};

/// How a recording ended.
struct RecordingResult {
  TrialSummary summary;
  std::optional<std::filesystem::path> spillFile;  ///< the whole trial, when the sink did not take it
  std::string problem;                             ///< what the sink said last; empty if it never failed
};

/// Takes samples from the servo's ring, packs them second by second, and hands the chunks to a sink. The sink
/// is called from one thread only: the recorder's own after start(), else the one that calls pump() and
/// finish(). All chunks of the trial are kept (about 25 MB an hour), so that a file can still get all of it
/// when the sink gives up half way.
class Recorder {
 public:
  /// Makes the recorder of one trial. `ring` and `sink` outlive it. Samples that the ring refused earlier
  /// are not counted.
  Recorder(SpscRing<Sample>& ring, TrialSink& sink, TrialHeader header, RecorderOptions options = {});
  /// Ends the recorder. Without finish() the trial stays as the sink has it: interrupted, with all chunks
  /// handed on so far.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Starts recording in a thread of its own.
  void start();
  /// Drains the ring and hands complete chunks to the sink; offers once more what the sink refused. A sink
  /// that fails never makes it throw. Not after start().
  void pump();
  /// Hands the rest and the summary to the sink. `health`: of a servo that ran in real time. Throws
  /// Error{kFileUnwritable} when neither sink nor file took the trial.
  [[nodiscard]] RecordingResult finish(TrialOutcome outcome, std::int64_t lateTicks,
                                       const std::optional<ServoHealth>& health = {});

  /// Returns the number of samples taken from the ring so far. Any thread.
  [[nodiscard]] std::int64_t samples() const noexcept { return taken_.load(std::memory_order_relaxed); }
  /// Tells whether the sink has given up and a file takes the trial. Any thread.
  [[nodiscard]] bool spilling() const noexcept { return spilling_.load(std::memory_order_relaxed); }

 private:
  void run();
  void pack();
  /// Hands complete chunks to the sink; false when it refused one.
  bool deliver();
  void finishSink();
  void spill();

  SpscRing<Sample>& ring_;
  TrialSink* sink_;  // the given one, or spillSink_
  TrialHeader header_;
  RecorderOptions options_;
  std::size_t refusedBefore_;
  ContentHash hash_;
  std::vector<Sample> gathered_;
  std::vector<TrialChunk> chunks_;
  std::size_t delivered_ = 0;  // chunks
  bool begun_ = false;
  int failures_ = 0;
  std::unique_ptr<TrialSink> spillSink_;
  RecordingResult result_;

  std::atomic<std::int64_t> taken_{0};
  std::atomic<bool> spilling_{false};
  std::thread thread_;
  std::mutex mutex_;  // guards stop_ and abandoned_ only; never touched by the servo
  std::condition_variable wake_;
  bool stop_ = false;
  bool abandoned_ = false;
  std::exception_ptr failure_;
};

}  // namespace torsio
