// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/record/trial.h"

namespace torsio {

/// Keeps a recording in memory: for replay right after the trial, and for tests.
class MemoryTrialSink final : public TrialSink {
 public:
  void begin(const TrialHeader& header) override {
    trial_ = {};
    trial_.header = header;
    trial_.summary.outcome = TrialOutcome::kInterrupted;
  }
  void append(const TrialChunk& chunk) override { trial_.chunks.push_back(chunk); }
  void finish(const TrialSummary& summary) override { trial_.summary = summary; }

  /// Returns the trial as far as it was recorded; its outcome is interrupted until finish().
  [[nodiscard]] const Trial& trial() const noexcept { return trial_; }

 private:
  Trial trial_;
};

}  // namespace torsio
