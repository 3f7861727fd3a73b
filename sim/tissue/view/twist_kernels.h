// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/tissue/view/cpu_isa.h"

namespace torsio {

/// Number of vertices in a block: within a block each coordinate is sixteen consecutive floats ("array of
/// structures of arrays"). One stream per block instead of sixteen, so that no two streams start at equal
/// addresses modulo 4 KiB, which would thrash a first-level cache.
inline constexpr int kKernelBlock = 16;

/// One frame of a twist about the centreline: the angle at a vertex of compliance C is
/// torque min(nearSlope C, farBase + farSlope C), the twist rate per C is nearRate before the grasp and
/// farRate beyond it, blended over graspCompliance +- 1 / (2 inverseBlend).
struct TwistFrame {
  float torque = 0.0F;           ///< N m
  float nearSlope = 1.0F;        ///< B(g): 1 for clamped-free
  float farBase = 0.0F;          ///< rad per N m
  float farSlope = 0.0F;         ///< 0 for clamped-free
  float graspCompliance = 0.0F;  ///< C(g), rad per N m
  float inverseBlend = 0.0F;     ///< 1 / width of the blend, in compliance
  float nearRate = 0.0F;         ///< torque dA/dC B(g)
  float farRate = 0.0F;          ///< torque A(g) dB/dC
};

/// One frame of the paper's linear rotation (Eqs. 21-23).
struct PaperFrame {
  float torque = 0.0F;      ///< N m
  float graspArc = 0.0F;    ///< m
  float graspAngle = 0.0F;  ///< rad per N m at the grasp; sections beyond it follow rigidly
};

/// Places along a span of a hollow organ are a row of floats, padded to whole blocks.
inline constexpr int kHollowRow = 80;

/// A wrung span at the angle and pressure of a frame, mixed from the four solved ones round them. A solved
/// span is [4][kHollowRow]: share of the turn; mean radius against rest; how slack the wall is, as what is
/// missing of 1; where the first crest has gone round to, rad.
struct HollowMix {
  const float* solved[4] = {};    ///< those of weight 0 may be any
  float weights[4] = {};          ///< of sum 1
  float turn = 0.0F;              ///< of the mobile part, half turns
  float waves = 3.0F;             ///< folds round the tube, below 0 if they run the other way round
  const float* depths = nullptr;  ///< of the folds, [kHollowDepths + 1], over sqrt(1 / slack^2 - 1)
  float depthsEach = 0.0F;        ///< steps of `depths` for 1
};
inline constexpr int kHollowDepths = 128;

/// One frame of a span of a hollow organ (docs/model.md H.8).
struct HollowFrame {
  const float* cells = nullptr;  ///< of hollowCells
  float waves = 3.0F;            ///< folds round the tube
  float point[3] = {};           ///< of the line that wound limbs turn about, m
  float direction[3] = {};       ///< of that line
  float first[3] = {};           ///< across it, of length 1
  float second[3] = {};          ///< direction x first
};

/// Component kriging of a set of key points as the paper prints it (Eq. 15): for each vertex eight weights
/// along the ridge and a share of the next ridge.
struct KrigedComponents {
  const float* weights = nullptr;        ///< [vertex][8]
  const int* first = nullptr;            ///< [vertex]: first section of the window on ridge K
  const int* firstNext = nullptr;        ///< [vertex]: the same on ridge K + 1
  const float* share = nullptr;          ///< [vertex]: 0 .. 1 towards ridge K + 1
  const float* displacements = nullptr;  ///< [key point][4]: dX, dY, dZ, 0; key point = ridge M + section
  const float* rest = nullptr;           ///< [vertex][3]
};

/// The per-frame loops for views, one table an instruction set. Float kernels are good to about 6e-7 of the
/// radius at a full turn. Every pointer is 64-byte aligned; `blocks` counts blocks of sixteen vertices;
/// inputs and outputs do not overlap unless said. What enters a recorded sample never comes from here: the
/// last bit depends on the instruction set.
struct TwistKernels {
  /// Moves vertices by a twist about the centreline, with warping. in: foot[3] radius[3] tangent[3]
  /// compliance psiRate = 11 x 16 a block; out: 3 x 16 a block. x' = foot + cos(phi) radius + sin(phi)
  /// tangent x radius + rate psiRate tangent.
  void (*curvedWarp)(const float* in, int blocks, const TwistFrame& frame, float* out);
  /// Moves vertices by a twist about the centreline, without warping: in as curvedWarp without psiRate, 10
  /// x 16 a block.
  void (*curved)(const float* in, int blocks, const TwistFrame& frame, float* out);
  /// Moves vertices by given angles. in: as curvedWarp; angle and rate per vertex: 2 x 16 a block.
  void (*givenAngles)(const float* in, const float* anglesAndRates, int blocks, float* out);
  /// Moves vertices by the paper's linear rotation. in: rest[3] tangentCrossRadius[3] unitAngle arc lift[3]
  /// = 11 x 16 a block; out: 3 x 16.
  void (*paperLinear)(const float* in, int blocks, const PaperFrame& frame, float* out);
  /// Computes a span's places. out: [4][kHollowRow]: turn in half turns; mean radius against rest; depth of
  /// the folds against that radius, times the cosine and the sine of their phase.
  void (*hollowPlaces)(const HollowMix& mix, float* out);
  /// Lays out places (of hollowPlaces) by cells, each two neighbouring ones as two straight pieces that meet
  /// in the middle row, middle + slope place + kink |place|, place in rows from there. out:
  /// [13][kHollowRow], at the first row of each cell: middle, slope and kink of the turn, of the radius and
  /// of both parts of the folds; then 0 where all three rows are free of folds.
  void (*hollowCells)(const float* places, float* out);
  /// Moves vertices of a span with its folds, each about an axis through its own section's centre. in:
  /// foot[3] lift[3] across[3] aside[3] round[2] place = 15 x 16 a block, m. `across` turns towards `aside`
  /// about the axis, `lift` lies along it, all three grow with the radius; `foot`: the rest. `round`: cosine
  /// and sine of the ridge angle times the number of waves; `place`: rows from the middle of the cell
  /// firstRows[block], -1 .. 1. out: 3 x 16.
  void (*hollowOwn)(const float* in, const int* firstRows, int blocks, const HollowFrame& frame, float* out);
  /// Moves vertices of limbs that are wound round the line of the frame. in: rest[3] across[3] aside[3]
  /// round[2] place = 12 x 16 a block, vectors along first, second, direction of the frame; `rest`: against
  /// the point of the line; `across`: from the section's axis; `aside`: tangent x across. out: 3 x 16.
  void (*hollowWound)(const float* in, const int* firstRows, int blocks, const HollowFrame& frame,
                      float* out);
  /// Moves a lattice section by section, each section padded to whole blocks of 3 x 16; motions: 12 numbers
  /// a section, rows of the matrix, then the translation.
  void (*lattice)(const float* in, int sections, int blocksPerSection, const float* motions, float* out);
  void (*latticeDouble)(const double* in, int sections, int blocksPerSection, const double* motions,
                        double* out);
  /// Computes displacement components by live kriging; out: [vertex][3].
  void (*componentKriging)(const KrigedComponents& components, int vertices, float* out);
  /// Writes blocks of 3 x 16 as interleaved xyz every `stride` floats; `vertices` are written.
  void (*interleave)(const float* in, int vertices, float* out, int stride);
  /// Computes out = a + factor b, the STREAM triad: the best that memory can do.
  void (*triad)(const float* a, const float* b, float factor, int count, float* out);
};

/// Returns the kernels for `isa`, which must be one of usableIsas(). Throws nothing.
[[nodiscard]] const TwistKernels& twistKernels(Isa isa) noexcept;

}  // namespace torsio
