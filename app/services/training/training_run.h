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

/// One stretch of a run.
struct RunPhase {
  PhaseId phaseId{};  ///< of the curriculum; empty: a run outside any phase
  std::string label{};
  PhaseKind arm = PhaseKind::kVirtual;
  std::int64_t duration_us = 0;
  std::int64_t done_us = 0;  ///< spent in earlier runs
  ModuleId moduleId{};       ///< what is practised; empty: the module of the run
};

/// What a trainee goes through (paper section 6): phases in their order and the rest that is allowed.
struct RunPlan {
  std::vector<RunPhase> phases{};
  std::int64_t restAllowance_us = 0;
  bool restSplittable = false;
  std::int64_t restTaken_us = 0;  ///< in earlier runs
};

enum class RunState {
  kReady,     ///< not begun
  kRunning,   ///< the clock of the phase runs
  kResting,   ///< the clock stands; the allowance runs
  kHandOver,  ///< between the virtual and the real arm: the clock stands for a moment
  kFinished,  ///< every phase is over
  kStopped,   ///< given up before the end
};

/// Something that the page or the record must know of.
struct RunEvent {
  enum class Kind {
    kPhaseBegan,
    kPhaseEnded,  ///< by its clock
    kRestBegan,
    kRestEnded,   ///< by the trainee
    kRestUsedUp,  ///< the allowance is used up: training goes on by itself
    kHandOver,    ///< go to the other arm
    kPaused,      ///< the machine slept or stood still: that time counts for nothing
    kFinished,
    kStopped,
  };
  Kind kind = Kind::kPhaseBegan;
  std::size_t phase = 0;
  std::int64_t at_us = 0;  ///< on the clock of the run
};

/// Time that was spent, to be logged.
struct ExposurePiece {
  PhaseId phaseId{};
  ExposureKind kind = ExposureKind::kVirtual;
  std::int64_t begun_us = 0;  ///< on the clock of the run
  std::int64_t duration_us = 0;
};

/// After the last virtual second the trainee has this long to go to the real arm; then its clock starts.
inline constexpr std::int64_t kLongestHandOver_us = 60'000'000;
/// A longer silence between two calls of advance() is a machine that slept, not training.
inline constexpr std::int64_t kLongestSilence_us = 10'000'000;
/// Exposure is handed out in pieces of this length: what a power cut can take of a real-arm phase.
inline constexpr std::int64_t kExposurePiece_us = 30'000'000;

/// The clock of a training run: virtual and real phases with automatic hand-over, rest with its allowance,
/// hard stop at the end. Driven by advance(), which a timer calls a few times a second; phase borders lie
/// exactly where they belong however late the call comes. A value without thread; the clock outlives it.
class TrainingRun {
 public:
  /// Throws Error{kBadParameter} when nothing is left to do or a duration makes no sense.
  TrainingRun(RunPlan plan, const Clock& clock);

  void start();
  /// Moves on to now. Returns what happened since the last call, in order.
  std::vector<RunEvent> advance();
  /// The trainee waits for the machine: the time since the last call counts for nothing while a phase runs.
  void hold();
  /// Refused (false) when no rest is left or the run does not go on.
  [[nodiscard]] bool rest();
  /// Ends a rest, or the hand-over before its time.
  void resume();
  /// Given up: what was done so far is kept.
  void stop();

  [[nodiscard]] RunState state() const noexcept { return state_; }
  [[nodiscard]] bool over() const noexcept {
    return state_ == RunState::kFinished || state_ == RunState::kStopped;
  }
  [[nodiscard]] const RunPlan& plan() const noexcept { return plan_; }
  /// Position of the present phase; in a hand-over that of the phase to come.
  [[nodiscard]] std::size_t phaseIndex() const noexcept { return phase_; }
  [[nodiscard]] const RunPhase& phase() const;
  [[nodiscard]] std::int64_t remainingInPhase_us() const;
  [[nodiscard]] bool mayRest() const noexcept;
  /// Of the rest that goes on, or of the allowance.
  [[nodiscard]] std::int64_t restLeft_us() const noexcept;
  [[nodiscard]] std::int64_t handOverLeft_us() const noexcept;

  /// Exposure since the last call: complete pieces, and with `all` also the begun one.
  [[nodiscard]] std::vector<ExposurePiece> takeExposure(bool all);

 private:
  void emit(RunEvent::Kind kind, std::int64_t at_us);
  void begin(std::int64_t at_us);
  /// Lets `span_us` pass in the present state from `from_us` on; returns how much of it was used.
  std::int64_t spend(std::int64_t from_us, std::int64_t span_us);
  void endPhase(std::int64_t at_us);
  void book(ExposureKind kind, std::int64_t from_us, std::int64_t span_us);

  RunPlan plan_;
  const Clock* clock_;
  RunState state_ = RunState::kReady;
  std::size_t phase_ = 0;
  bool restUsed_ = false;  // a rest that may not be split was taken
  std::int64_t handOverLeft_us_ = 0;
  std::int64_t last_us_ = 0;  // up to here time has been accounted for
  std::vector<RunEvent> events_;
  std::vector<ExposurePiece> pieces_;  // the last one may still grow
};

}  // namespace torsio
