// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"
#include "sim/core/clock.h"

namespace torsio {

/// One phase of a run.
struct RunPhase {
  PhaseId phaseId{};  ///< of the curriculum; empty: outside any phase
  std::string label{};
  PhaseKind arm = PhaseKind::kVirtual;
  std::int64_t duration_us = 0;
  std::int64_t done_us = 0;  ///< in earlier runs
  ModuleId moduleId{};       ///< empty: the module of the run
};

/// A trainee's schedule (paper section 6): phases in order, and the rest allowed.
struct RunPlan {
  std::vector<RunPhase> phases{};
  std::int64_t restAllowance_us = 0;
  bool restSplittable = false;
  std::int64_t restTaken_us = 0;  ///< in earlier runs
};

enum class RunState {
  kReady,     ///< not started
  kRunning,   ///< the clock of the phase runs
  kResting,   ///< the phase's clock is stopped; the allowance is running
  kHandOver,  ///< between virtual and real arm: the clock is stopped briefly
  kFinished,  ///< every phase is over
  kStopped,   ///< given up before the end
};

/// An event for the page or the record.
struct RunEvent {
  enum class Kind {
    kPhaseBegan,
    kPhaseEnded,  ///< time is up
    kRestBegan,
    kRestEnded,   ///< by the trainee
    kRestUsedUp,  ///< the allowance is used up: training continues automatically
    kHandOver,    ///< change to the other arm
    kPaused,      ///< the machine slept or hung: that time does not count
    kFinished,
    kStopped,
  };
  Kind kind = Kind::kPhaseBegan;
  std::size_t phase = 0;
  std::int64_t at_us = 0;  ///< by the run's clock
};

/// Training time to log.
struct ExposurePiece {
  PhaseId phaseId{};
  ExposureKind kind = ExposureKind::kVirtual;
  std::int64_t begun_us = 0;  ///< by the run's clock
  std::int64_t duration_us = 0;
};

/// Maximum time for changing to the real arm after a virtual phase; then its clock starts.
inline constexpr std::int64_t kLongestHandOver_us = 60'000'000;
/// A longer gap between two calls of advance() means that the machine slept, and is not training.
inline constexpr std::int64_t kLongestSilence_us = 10'000'000;
/// Training time is logged in pieces of this length, the most that a power cut can lose of a real-arm phase.
inline constexpr std::int64_t kExposurePiece_us = 30'000'000;

/// The clock of a training run: virtual and real phases with automatic hand-over, rest with an allowance,
/// hard stop at the end. A timer calls advance() a few times per second; phase boundaries are exact however
/// late the calls are. A value type without thread; the clock outlives it.
class TrainingRun {
 public:
  /// Throws Error{kBadParameter} if nothing is left to do or a duration is invalid.
  TrainingRun(RunPlan plan, const Clock& clock);

  void start();
  /// Advances to the current time. Returns the events since the last call, in order.
  std::vector<RunEvent> advance();
  /// Discards the time since the last call during a phase, because the trainee is waiting for the machine.
  void hold();
  /// Returns false if no rest is left or the run is not running.
  [[nodiscard]] bool rest();
  /// Ends a rest, or a hand-over early.
  void resume();
  /// Stops early; time so far is kept.
  void stop();

  [[nodiscard]] RunState state() const noexcept { return state_; }
  [[nodiscard]] bool over() const noexcept {
    return state_ == RunState::kFinished || state_ == RunState::kStopped;
  }
  [[nodiscard]] const RunPlan& plan() const noexcept { return plan_; }
  /// Returns the index of the current phase; during a hand-over, of the next one.
  [[nodiscard]] std::size_t phaseIndex() const noexcept { return phase_; }
  [[nodiscard]] const RunPhase& phase() const;
  [[nodiscard]] std::int64_t remainingInPhase_us() const;
  [[nodiscard]] bool mayRest() const noexcept;
  /// Returns what is left of the current rest, or of the allowance.
  [[nodiscard]] std::int64_t restLeft_us() const noexcept;
  [[nodiscard]] std::int64_t handOverLeft_us() const noexcept;

  /// Returns training time since the last call: complete pieces, and with `all` also the incomplete one.
  [[nodiscard]] std::vector<ExposurePiece> takeExposure(bool all);

 private:
  void emit(RunEvent::Kind kind, std::int64_t at_us);
  void begin(std::int64_t at_us);
  /// Accounts `span_us` from `from_us` in the current state; returns how much of it was used.
  std::int64_t spend(std::int64_t from_us, std::int64_t span_us);
  void endPhase(std::int64_t at_us);
  void book(ExposureKind kind, std::int64_t from_us, std::int64_t span_us);

  RunPlan plan_;
  const Clock* clock_;
  RunState state_ = RunState::kReady;
  std::size_t phase_ = 0;
  bool restUsed_ = false;  // an indivisible rest was taken
  std::int64_t handOverLeft_us_ = 0;
  std::int64_t last_us_ = 0;  // time is accounted for up to here
  std::vector<RunEvent> events_;
  std::vector<ExposurePiece> pieces_;  // the last one may still grow
};

}  // namespace torsio
