// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/training_run.h"

#include <algorithm>
#include <utility>

#include "assessment/domain/ids.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

std::int64_t left_us(const RunPhase& phase) {
  return phase.duration_us - phase.done_us;
}

void check(const RunPlan& plan) {
  const bool sound = plan.restAllowance_us >= 0 && plan.restTaken_us >= 0 &&
                     std::all_of(plan.phases.begin(), plan.phases.end(), [](const RunPhase& phase) {
                       return phase.duration_us > 0 && phase.done_us >= 0;
                     });
  if (!sound) {
    refuseParameter(Text::tr("a phase or a rest has no sensible length"), Text::tr("run"),
                    Text::tr("Correct the curriculum"));
  }
  const bool something = std::any_of(plan.phases.begin(), plan.phases.end(),
                                     [](const RunPhase& phase) { return left_us(phase) > 0; });
  if (something) {
    return;
  }
  refuseParameter(Text::tr("no training time is left"), Text::tr("run"),
                  Text::tr("Ask an administrator what comes next"));
}

}  // namespace

TrainingRun::TrainingRun(RunPlan plan, const Clock& clock) : plan_(std::move(plan)), clock_(&clock) {
  check(plan_);
  while (left_us(plan_.phases[phase_]) <= 0) {
    ++phase_;
  }
  restUsed_ = plan_.restTaken_us > 0;
}

const RunPhase& TrainingRun::phase() const {
  return plan_.phases.at(phase_);
}

void TrainingRun::emit(RunEvent::Kind kind, std::int64_t at_us) {
  events_.push_back({kind, phase_, at_us});
}

void TrainingRun::begin(std::int64_t at_us) {
  state_ = RunState::kRunning;
  handOverLeft_us_ = 0;
  emit(RunEvent::Kind::kPhaseBegan, at_us);
}

void TrainingRun::start() {
  TORSIO_EXPECTS(state_ == RunState::kReady);
  last_us_ = clock_->now_us();
  begin(last_us_);
}

void TrainingRun::book(ExposureKind kind, std::int64_t from_us, std::int64_t span_us) {
  const PhaseId phaseId = kind == ExposureKind::kRest ? PhaseId() : phase().phaseId;
  while (span_us > 0) {
    const bool goesOn = !pieces_.empty() && pieces_.back().kind == kind &&
                        pieces_.back().phaseId == phaseId &&
                        pieces_.back().begun_us + pieces_.back().duration_us == from_us &&
                        pieces_.back().duration_us < kExposurePiece_us;
    if (!goesOn) {
      pieces_.push_back({phaseId, kind, from_us, 0});
    }
    const std::int64_t part_us = std::min(span_us, kExposurePiece_us - pieces_.back().duration_us);
    pieces_.back().duration_us += part_us;
    from_us += part_us;
    span_us -= part_us;
  }
}

void TrainingRun::endPhase(std::int64_t at_us) {
  emit(RunEvent::Kind::kPhaseEnded, at_us);
  const PhaseKind before = phase().arm;
  std::size_t next = phase_ + 1;
  while (next < plan_.phases.size() && left_us(plan_.phases[next]) <= 0) {
    ++next;
  }
  if (next == plan_.phases.size()) {
    state_ = RunState::kFinished;
    emit(RunEvent::Kind::kFinished, at_us);
    return;
  }
  phase_ = next;
  if (phase().arm == before) {
    begin(at_us);
    return;
  }
  state_ = RunState::kHandOver;
  handOverLeft_us_ = kLongestHandOver_us;
  emit(RunEvent::Kind::kHandOver, at_us);
}

std::int64_t TrainingRun::spend(std::int64_t from_us, std::int64_t span_us) {
  if (state_ == RunState::kRunning) {
    const std::int64_t used_us = std::min(span_us, remainingInPhase_us());
    book(exposureIn(phase().arm), from_us, used_us);
    plan_.phases[phase_].done_us += used_us;
    if (remainingInPhase_us() == 0) {
      endPhase(from_us + used_us);
    }
    return used_us;
  }
  if (state_ == RunState::kResting) {
    const std::int64_t used_us = std::min(span_us, restLeft_us());
    book(ExposureKind::kRest, from_us, used_us);
    plan_.restTaken_us += used_us;
    if (restLeft_us() == 0) {
      state_ = RunState::kRunning;
      emit(RunEvent::Kind::kRestUsedUp, from_us + used_us);
    }
    return used_us;
  }
  const std::int64_t used_us = std::min(span_us, handOverLeft_us_);
  handOverLeft_us_ -= used_us;
  if (handOverLeft_us_ == 0) {
    begin(from_us + used_us);
  }
  return used_us;
}

std::vector<RunEvent> TrainingRun::advance() {
  const std::int64_t now_us = clock_->now_us();
  const bool moves = state_ != RunState::kReady && !over();
  if (moves && now_us - last_us_ > kLongestSilence_us) {
    emit(RunEvent::Kind::kPaused, now_us);
    last_us_ = now_us;
  }
  while (moves && !over() && last_us_ < now_us) {
    last_us_ += spend(last_us_, now_us - last_us_);
  }
  last_us_ = now_us;
  return std::exchange(events_, {});
}

void TrainingRun::hold() {
  if (state_ == RunState::kRunning) {
    last_us_ = clock_->now_us();
  }
}

bool TrainingRun::mayRest() const noexcept {
  const bool left = plan_.restTaken_us < plan_.restAllowance_us;
  return state_ == RunState::kRunning && left && (plan_.restSplittable || !restUsed_);
}

bool TrainingRun::rest() {
  if (!mayRest()) {
    return false;
  }
  restUsed_ = true;
  state_ = RunState::kResting;
  emit(RunEvent::Kind::kRestBegan, last_us_);
  return true;
}

void TrainingRun::resume() {
  if (state_ == RunState::kHandOver) {
    begin(last_us_);
  } else if (state_ == RunState::kResting) {
    state_ = RunState::kRunning;
    emit(RunEvent::Kind::kRestEnded, last_us_);
  }
}

void TrainingRun::stop() {
  if (over()) {
    return;
  }
  state_ = RunState::kStopped;
  emit(RunEvent::Kind::kStopped, last_us_);
}

std::int64_t TrainingRun::remainingInPhase_us() const {
  return std::max<std::int64_t>(0, left_us(phase()));
}

std::int64_t TrainingRun::restLeft_us() const noexcept {
  const bool spent = !plan_.restSplittable && restUsed_ && state_ != RunState::kResting;
  return spent ? 0 : std::max<std::int64_t>(0, plan_.restAllowance_us - plan_.restTaken_us);
}

std::int64_t TrainingRun::handOverLeft_us() const noexcept {
  return state_ == RunState::kHandOver ? handOverLeft_us_ : 0;
}

std::vector<ExposurePiece> TrainingRun::takeExposure(bool all) {
  std::vector<ExposurePiece> taken = std::move(pieces_);
  pieces_.clear();
  const bool growing = !all && !taken.empty() && taken.back().duration_us < kExposurePiece_us;
  if (growing) {
    pieces_.push_back(taken.back());
    taken.pop_back();
  }
  return taken;
}

}  // namespace torsio
