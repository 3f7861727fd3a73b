// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace torsio {

/// Folds round a wrung tube at one place along it: waves that run up the tube as a helix and keep the length
/// of the perimeter (docs/model.md H.8).
struct FoldWaves {
  int waves = 3;           ///< round the tube, at least 3
  double amplitude = 0.0;  ///< eps, against the mean radius there: 0 .. kDeepestFold
  double crest_rad = 0.0;  ///< chi: where the first crest has gone round to
};

/// Beyond so deep a fold its sides would touch.
inline constexpr double kDeepestFold = 0.5;
inline constexpr int kMinDrawnWaves = 3;
inline constexpr int kMaxDrawnWaves = 9;

/// Returns how many waves are drawn for so many folds: two are drawn as three, because two reach the deepest
/// fold before the tube is a tenth narrower.
[[nodiscard]] int drawnWaves(int waves) noexcept;

/// Returns how deep so many waves must be for the perimeter to stay what it was unfolded, where the mean
/// radius is `slack` of the one that the perimeter would fill round: from a table made by bisection. 0 at
/// slack 1, kDeepestFold where the folds cannot take up more. Any thread.
[[nodiscard]] double foldAmplitude(int waves, double slack) noexcept;

/// The table of foldAmplitude() for so many waves: depths at equal steps of sqrt(1 / slack^2 - 1) from 0; the
/// last is that of all that is slacker.
struct FoldDepths {
  static constexpr int kSteps = 128;
  std::array<float, kSteps + 1> depths{};
  float each = 0.0F;  ///< steps for 1
};
[[nodiscard]] const FoldDepths& foldDepths(int waves) noexcept;

/// Returns the length of a folded perimeter against that of a circle of its mean radius.
[[nodiscard]] double foldedPerimeter(int waves, double amplitude) noexcept;

/// Where a point of the wall lies on its fold.
struct FoldedPoint {
  double radius = 1.0;  ///< against the mean radius
  double turn_rad = 0.0;
};

/// How deep folds are at a place and where their first crest lies, as the two parts of a wave:
/// eps cos(waves chi), eps sin(waves chi). Places in between are mixed from such parts, so that no angle has
/// to be taken there.
struct FoldPhase {
  double even = 0.0;
  double odd = 0.0;
};
[[nodiscard]] FoldPhase foldPhase(const FoldWaves& folds) noexcept;

/// A wave round the section at an angle: cos(waves angle), sin(waves angle).
struct RoundWave {
  double cos = 1.0;
  double sin = 0.0;
};
[[nodiscard]] RoundWave roundWave(int waves, double round_rad) noexcept;

/// Computes where the point at an angle round the section lies; without an amplitude exactly where it was.
/// Inextensible to first order in the amplitude, evenly stretched to second.
[[nodiscard]] FoldedPoint foldedPoint(int waves, const FoldPhase& phase, const RoundWave& round) noexcept;

}  // namespace torsio
