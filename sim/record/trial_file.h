// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "sim/record/trial.h"

namespace torsio {

/// A trial as one file, written while it is recorded: where a recording goes when the database cannot take
/// it, and how a trial travels. Each record carries its own digest and is flushed at once; until finish() the
/// file has the ending ".part", so that a crash leaves a readable file that is not taken for a complete one.
class TrialFileSink final : public TrialSink {
 public:
  /// Makes a sink for `file`, whose folder must exist; nothing is written before begin(). `context` is kept
  /// with the trial: any text that readers understand; empty: none.
  explicit TrialFileSink(std::filesystem::path file, std::string context = {});

  void begin(const TrialHeader& header) override;
  void append(const TrialChunk& chunk) override;
  void finish(const TrialSummary& summary) override;

 private:
  void write(const std::string& bytes);

  std::filesystem::path file_;
  std::string context_;
  std::ofstream out_;
  std::uintmax_t sound_ = 0;  // bytes of the file that are whole records
};

/// A trial file with what its writer added.
struct TrialFile {
  Trial trial;
  std::string context;    ///< of TrialFileSink; empty: none
  bool finished = false;  ///< false: cut off
};

/// Reads a trial file with its context. Otherwise as readTrialFile, with the same errors.
[[nodiscard]] TrialFile openTrialFile(const std::filesystem::path& file);

/// Reads a trial file, whole or cut off after any record. The outcome of one that was cut off is
/// kInterrupted, its content hash that of the records that are there. Throws Error (kFileMissing,
/// kFileUnreadable, kBadData).
[[nodiscard]] Trial readTrialFile(const std::filesystem::path& file);

}  // namespace torsio
