// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "sim/record/trial.h"

namespace torsio {

/// The recorder's ring holds eight seconds, enough for two calls of this length.
inline constexpr std::chrono::milliseconds kSinkPatience{3'500};

/// A sink whose calls return within `patience`: each call runs in the sink's own thread. If one takes longer,
/// it is abandoned, and this and all further calls throw DbError{kUnreachable}; the recorder then keeps the
/// trial in a file, at `place`. For servers that hang, which no connection time-out detects.
class TimedTrialSink final : public SpillingTrialSink {
 public:
  explicit TimedTrialSink(std::unique_ptr<TrialSink> sink, SpillPlace place = {},
                          std::chrono::milliseconds patience = kSinkPatience);
  ~TimedTrialSink() override;
  TimedTrialSink(const TimedTrialSink&) = delete;
  TimedTrialSink& operator=(const TimedTrialSink&) = delete;

  void begin(const TrialHeader& header) override;
  void append(const TrialChunk& chunk) override;
  void finish(const TrialSummary& summary) override;
  [[nodiscard]] SpillPlace spillPlace() const override { return place_; }

 private:
  struct State;
  using Call = std::function<void(TrialSink&)>;
  void call(Call call);
  static void run(const std::shared_ptr<State>& state);

  std::shared_ptr<State> state_;
  std::thread thread_;  // from the first call
  SpillPlace place_;
  std::chrono::milliseconds patience_;
  bool lost_ = false;
};

}  // namespace torsio
