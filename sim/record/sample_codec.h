// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/record/trial.h"

namespace torsio {

/// Samples a chunk holds when the recorder is not told otherwise: one second.
inline constexpr std::int64_t kSamplesPerChunk = 1000;
/// Samples a chunk may hold at most.
inline constexpr std::int64_t kLargestChunk = 60'000;

/// Steps in which a chunk stores the answers of the model. Everything that went into the model (device,
/// command) and every integer is stored exactly; the exact doubles of the answer are stored as a digest,
/// and a replay finds them again bit for bit (replay_trial.h).
inline constexpr double kAngleStep_rad = 1e-7;
inline constexpr double kTorqueStep_Nm = 1e-6;
inline constexpr double kForceStep_N = 1e-5;
inline constexpr double kDepthStep_m = 1e-7;
inline constexpr double kArcStep_m = 1e-6;
inline constexpr double kPressureStep_Pa = 0.1;
inline constexpr double kShareStep = 1e-6;  ///< of patency and flow
inline constexpr double kDoseStep = 1e-7;

/// Packs consecutive samples: integer columns, polynomial prediction of the order that suits each column
/// (0 to 4), byte shuffle, zstd. `samples`: 1 .. kLargestChunk, ticks strictly increasing, doubles finite.
/// Any one thread; allocates.
[[nodiscard]] TrialChunk encodeChunk(std::int64_t index, std::span<const Sample> samples);

/// Decodes the samples of a chunk, with their answers in steps. Throws Error{kBadData} for anything that
/// encodeChunk cannot have made: wrong digest, other version, damaged bytes, values out of range.
[[nodiscard]] std::vector<Sample> decodeChunk(const TrialChunk& chunk);

/// Decodes all samples of a trial in order. Throws Error{kBadData}, also for chunks out of order.
[[nodiscard]] std::vector<Sample> decodeTrial(const Trial& trial);

/// Returns `sample` with its answers rounded to the stored steps: what decoding gives back.
[[nodiscard]] Sample inStoredSteps(const Sample& sample) noexcept;

/// Computes TrialChunk::digest: over index, first tick, sample count and bytes.
[[nodiscard]] std::string chunkDigest(const TrialChunk& chunk);

/// Computes TrialChunk::outputDigest: over the exact bits of response and sent force of every sample, and of
/// what a hollow organ is like where the rules are those of an untwisting.
[[nodiscard]] std::string outputDigest(std::span<const Sample> samples);

}  // namespace torsio
