// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/core/live_types.h"
#include "sim/scene/scene.h"
#include "sim/servo/exercise.h"

namespace torsio {

/// What the exercise of a recorded trial answered, computed again on several threads: the trial is cut where
/// the record says that nothing is touched and the organ lies at rest, and each piece is begun as if it were
/// so. What a piece ended with decides: only when it was so are the answers of the next piece taken, else it
/// is stepped on from there. So every answer is that of one exercise stepped from the first sample on, bit
/// for bit, whatever the record says.
///
/// A scene with a wall that came twisted, or with an asynchronous model, never comes to such a place: it
/// is stepped on one thread. One thread asks.
class ExerciseAhead {
 public:
  /// Prepares for `recorded`, consecutive samples from tick 0 on, which outlive it as `scene` does. `threads`
  /// >= 1: that compute at the same time.
  ExerciseAhead(const Scene& scene, const ExerciseOptions& options, std::span<const Sample> recorded,
                unsigned threads);

  /// Tells whether the answers of this scene can be computed ahead.
  [[nodiscard]] static bool suits(const Scene& scene) noexcept;
  /// Returns the answer of the next sample; there is one.
  [[nodiscard]] const ExerciseStep& next();
  /// Returns how many pieces did not begin as the record said and were stepped again.
  [[nodiscard]] std::size_t piecesAgain() const noexcept { return again_; }

 private:
  /// Samples of one thread, and how the exercise was behind them.
  struct Piece {
    std::size_t first = 0;
    std::size_t end = 0;
    Exercise exercise;
  };

  [[nodiscard]] std::size_t pieceEnd(std::size_t first);
  void step(Piece& piece) noexcept;
  void computeMore();

  const Scene& scene_;
  ExerciseOptions options_;
  std::span<const Sample> recorded_;
  unsigned threads_;
  Exercise exercise_;                  // behind the last answer that counts
  std::vector<ExerciseStep> answers_;  // from begun_ on
  std::size_t begun_ = 0;
  std::size_t at_ = 0;
  bool jawClosed_ = true;  // behind the last sample that was looked at
  std::size_t again_ = 0;
};

}  // namespace torsio
