// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/exercise_ahead.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include "sim/core/contracts.h"
#include "sim/core/float_mode.h"
#include "sim/core/tissue_model.h"

namespace torsio {

namespace {

constexpr std::size_t kShortestPiece = 500;    // samples: shorter ones cost more than they bring
constexpr std::size_t kMaxAtOnce = 64 * 1024;  // samples: 20 MB of answers

/// An exercise with its constants as those of a servo loop.
Exercise begunAnew(const ExerciseOptions& options, const Scene& scene) {
  const PinnedFloatMode defaults;
  return Exercise(options, scene);
}

/// Tells whether a piece may begin behind `before`, by what is recorded.
bool seemsSettled(const Sample& before) noexcept {
  return before.phase == ExercisePhase::kTracking && before.contact == kContactNone;
}

}  // namespace

ExerciseAhead::ExerciseAhead(const Scene& scene, const ExerciseOptions& options,
                             std::span<const Sample> recorded, unsigned threads)
    : scene_(scene),
      options_(options),
      recorded_(recorded),
      threads_(std::max(1U, threads)),
      exercise_(begunAnew(options, scene)),
      jawClosed_(exercise_.jawClosed()) {}

bool ExerciseAhead::suits(const Scene& scene) noexcept {
  return GraspedTissue(scene, kTickPeriod_us).forgets();
}

const ExerciseStep& ExerciseAhead::next() {
  if (at_ == begun_ + answers_.size()) {
    computeMore();
  }
  return answers_[at_++ - begun_];
}

/// Also follows the jaw up to there.
std::size_t ExerciseAhead::pieceEnd(std::size_t first) {
  for (std::size_t i = first; i < recorded_.size(); ++i) {
    jawClosed_ = Exercise::jawCloses(jawClosed_, toolState(recorded_[i].device));
    if (i + 1 - first >= kShortestPiece && seemsSettled(recorded_[i])) {
      return i + 1;
    }
  }
  return recorded_.size();
}

void ExerciseAhead::step(Piece& piece) noexcept {
  const PinnedFloatMode defaults;
  for (std::size_t i = piece.first; i < piece.end; ++i) {
    const Sample& sample = recorded_[i];
    piece.exercise.apply(sample.command);
    answers_[i - begun_] = piece.exercise.step(toolState(sample.device));
  }
}

void ExerciseAhead::computeMore() {
  begun_ = at_;
  TORSIO_EXPECTS(begun_ < recorded_.size());
  const Exercise anew = begunAnew(options_, scene_);
  std::vector<Piece> pieces;
  for (std::size_t first = begun_; first < recorded_.size() && first - begun_ < kMaxAtOnce;) {
    Piece piece{first, 0, exercise_};
    if (!pieces.empty()) {
      piece.exercise = anew;
      piece.exercise.setJaw(jawClosed_);
    }
    piece.end = pieceEnd(first);
    first = piece.end;
    pieces.push_back(piece);
  }
  answers_.assign(pieces.back().end - begun_, {});
  std::atomic<std::size_t> taken{0};
  const auto work = [&] {
    for (std::size_t i = taken++; i < pieces.size(); i = taken++) {
      step(pieces[i]);
    }
  };
  {
    std::vector<std::jthread> others(std::min<std::size_t>(threads_, pieces.size()) - 1);
    for (std::jthread& other : others) {
      other = std::jthread(work);
    }
    work();
  }
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const Exercise& before = pieces[i - 1].exercise;
    // The jaw follows from the samples alone.
    if (!before.settled()) {
      pieces[i].exercise = before;
      step(pieces[i]);
      ++again_;
    }
  }
  exercise_ = pieces.back().exercise;
}

}  // namespace torsio
