// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/record/sample_codec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include <zstd.h>

#include "sim/core/contracts.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/record/column_codec.h"

namespace torsio {

namespace {

// bytes = magic, version, then one zstd frame (with its own checksum) over the columns in this order.
constexpr std::array<std::uint8_t, 4> kChunkMagic{'T', 'R', 'S', 'C'};
constexpr std::uint8_t kVersion = 1;        // the columns up to kRules
constexpr std::uint8_t kVersionAsync = 2;   // up to kAsyncSlope: an asynchronous model has answered
constexpr std::uint8_t kVersionHollow = 3;  // all: a hollow organ that came twisted
constexpr std::size_t kHeaderSize = kChunkMagic.size() + 1;
constexpr int kCompressionLevel = 3;

enum Column : std::size_t {
  kTick,
  kTime,
  kPositionX,
  kPositionY,
  kPositionZ,
  kOrientationW,
  kOrientationX,
  kOrientationY,
  kOrientationZ,
  kRoll,
  kGrip,
  kButtons,
  kStatus,
  kCommandKind,
  kCommandValue,
  kPhase,
  kLimits,
  kAngle,
  kTorque,
  kWantedX,
  kWantedY,
  kWantedZ,
  kDepth,
  kGraspArc,
  kSentX,
  kSentY,
  kSentZ,
  kContact,
  kRules,
  kAsyncState,
  kAsyncAngle,  // the bits of the doubles, as of the value of a command: inputs are kept exactly
  kAsyncTorque,
  kAsyncSlope,
  kPressure,
  kNarrowing,  // 1 - patency, so that 0 is an organ at rest
  kWant,       // 1 - flow
  kDose,
  kColumns
};
constexpr std::size_t kColumnsWithoutAsync = kAsyncState;
constexpr std::size_t kColumnsWithoutHollow = kPressure;

using Row = std::array<std::int64_t, kColumns>;

[[noreturn]] void damaged(Phrase what) {
  throw Error(ErrorCode::kBadData, what, Text::verbatim("recorded chunk"),
              Text::verbatim("The recording is damaged: restore it from a copy"));
}

/// Nearest multiple of `step`; saturates, so that no input overflows. Samples hold no NaN (the servo sees to
/// it); if one came it would be 0 here and still show in the output digest.
std::int64_t toSteps(double value, double step) noexcept {
  constexpr double kLimit = 0x1p62;
  if (std::isnan(value)) {
    return 0;
  }
  const double steps = std::clamp(value / step, -kLimit, kLimit);
  return static_cast<std::int64_t>(steps < 0.0 ? steps - 0.5 : steps + 0.5);
}

Row toRow(const Sample& s) noexcept {
  Row row{};
  row[kTick] = s.tick;
  row[kTime] = s.device.time_us;
  for (std::size_t i = 0; i < 3; ++i) {
    row[kPositionX + i] = s.device.position[i];
  }
  for (std::size_t i = 0; i < 4; ++i) {
    row[kOrientationW + i] = s.device.orientation[i];
  }
  row[kRoll] = s.device.roll;
  row[kGrip] = s.device.grip;
  row[kButtons] = s.device.buttons;
  row[kStatus] = s.device.status;
  row[kCommandKind] = static_cast<std::int64_t>(s.command.kind);
  row[kCommandValue] = std::bit_cast<std::int64_t>(s.command.value);
  row[kPhase] = static_cast<std::int64_t>(s.phase);
  row[kLimits] = s.limits;
  row[kAngle] = toSteps(s.response.angle_rad, kAngleStep_rad);
  row[kTorque] = toSteps(s.response.torque_Nm, kTorqueStep_Nm);
  row[kWantedX] = toSteps(s.response.force_N.x, kForceStep_N);
  row[kWantedY] = toSteps(s.response.force_N.y, kForceStep_N);
  row[kWantedZ] = toSteps(s.response.force_N.z, kForceStep_N);
  row[kDepth] = toSteps(s.response.depth_m, kDepthStep_m);
  row[kGraspArc] = toSteps(s.response.graspArc_m, kArcStep_m);
  row[kSentX] = toSteps(s.force_N.x, kForceStep_N);
  row[kSentY] = toSteps(s.force_N.y, kForceStep_N);
  row[kSentZ] = toSteps(s.force_N.z, kForceStep_N);
  row[kContact] = s.contact;
  row[kRules] = s.rules;
  row[kAsyncState] = static_cast<std::int64_t>(s.async.state);
  row[kAsyncAngle] = std::bit_cast<std::int64_t>(s.async.angle_rad);
  row[kAsyncTorque] = std::bit_cast<std::int64_t>(s.async.torque_Nm);
  row[kAsyncSlope] = std::bit_cast<std::int64_t>(s.async.slope_Nm_per_rad);
  row[kPressure] = toSteps(s.hollow.pressure_Pa, kPressureStep_Pa);
  row[kNarrowing] = toSteps(1.0 - s.hollow.patency, kShareStep);
  row[kWant] = toSteps(1.0 - s.hollow.flow, kShareStep);
  row[kDose] = toSteps(s.hollow.dose, kDoseStep);
  return row;
}

template <typename Integer>
Integer within(std::int64_t value) {
  if (value < std::numeric_limits<Integer>::min() || value > std::numeric_limits<Integer>::max()) {
    damaged(Text::verbatim("a value is outside its range"));
  }
  return static_cast<Integer>(value);
}

/// Answers only: shared by decoding and inStoredSteps.
void answersFromRow(const Row& row, Sample& s) noexcept {
  const auto value = [&row](Column column, double step) { return static_cast<double>(row[column]) * step; };
  s.response.angle_rad = value(kAngle, kAngleStep_rad);
  s.response.torque_Nm = value(kTorque, kTorqueStep_Nm);
  s.response.force_N = {value(kWantedX, kForceStep_N), value(kWantedY, kForceStep_N),
                        value(kWantedZ, kForceStep_N)};
  s.response.depth_m = value(kDepth, kDepthStep_m);
  s.response.graspArc_m = value(kGraspArc, kArcStep_m);
  s.force_N = {value(kSentX, kForceStep_N), value(kSentY, kForceStep_N), value(kSentZ, kForceStep_N)};
  s.hollow = {value(kPressure, kPressureStep_Pa), 1.0 - value(kNarrowing, kShareStep),
              1.0 - value(kWant, kShareStep), value(kDose, kDoseStep)};
}

/// Refuses what no hollow organ is like.
void checkHollow(const Row& row) {
  constexpr double kMaxPressure_Pa = 1e6;
  constexpr double kMaxDose = 1e6;
  const auto inside = [&row](Column column, double step, double most) {
    return row[column] >= 0 && static_cast<double>(row[column]) * step <= most;
  };
  if (!inside(kPressure, kPressureStep_Pa, kMaxPressure_Pa) || !inside(kNarrowing, kShareStep, 1.0) ||
      !inside(kWant, kShareStep, 1.0) || !inside(kDose, kDoseStep, kMaxDose)) {
    damaged(Text::verbatim("a hollow organ that makes no sense"));
  }
}

AsyncAnswer asyncOf(const Row& row) {
  constexpr auto kLastState = static_cast<std::int64_t>(AsyncState::kBroken);
  const std::int64_t state = row[kAsyncState];
  const AsyncAnswer answer{static_cast<AsyncState>(state), std::bit_cast<double>(row[kAsyncAngle]),
                           std::bit_cast<double>(row[kAsyncTorque]), std::bit_cast<double>(row[kAsyncSlope])};
  const bool finite = std::isfinite(answer.angle_rad) && std::isfinite(answer.torque_Nm) &&
                      std::isfinite(answer.slope_Nm_per_rad);
  if (state < 0 || state > kLastState || !finite) {
    damaged(Text::verbatim("an answer of a model that makes no sense"));
  }
  return answer;
}

Sample toSample(const Row& row) {
  constexpr auto kLastKind = static_cast<std::int64_t>(ServoCommand::Kind::kCheckFlow);
  constexpr auto kLastPhase = static_cast<std::int64_t>(ExercisePhase::kReleased);
  Sample s;
  s.tick = row[kTick];
  s.device.time_us = row[kTime];
  for (std::size_t i = 0; i < 3; ++i) {
    s.device.position[i] = within<std::int32_t>(row[kPositionX + i]);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    s.device.orientation[i] = within<std::int32_t>(row[kOrientationW + i]);
  }
  s.device.roll = within<std::int32_t>(row[kRoll]);
  s.device.grip = within<std::int32_t>(row[kGrip]);
  s.device.buttons = within<std::uint32_t>(row[kButtons]);
  s.device.status = within<std::uint32_t>(row[kStatus]);
  if (row[kCommandKind] < 0 || row[kCommandKind] > kLastKind) {
    damaged(Text::verbatim("an unknown command"));
  }
  if (row[kPhase] < 0 || row[kPhase] > kLastPhase) {
    damaged(Text::verbatim("an unknown phase"));
  }
  s.command.kind = static_cast<ServoCommand::Kind>(row[kCommandKind]);
  s.command.value = std::bit_cast<double>(row[kCommandValue]);
  if (!std::isfinite(s.command.value)) {
    damaged(Text::verbatim("a command value that is not finite"));
  }
  s.phase = static_cast<ExercisePhase>(row[kPhase]);
  s.limits = within<std::uint32_t>(row[kLimits]);
  s.contact = within<std::uint32_t>(row[kContact]);
  s.rules = within<std::uint32_t>(row[kRules]);
  s.async = asyncOf(row);
  checkHollow(row);
  answersFromRow(row, s);
  return s;
}

std::size_t columnsOf(std::uint8_t version) noexcept {
  switch (version) {
    case kVersion:
      return kColumnsWithoutAsync;
    case kVersionAsync:
      return kColumnsWithoutHollow;
    default:
      return kColumns;
  }
}

std::uint8_t versionFor(std::span<const Sample> samples) noexcept {
  const bool hollow = std::any_of(samples.begin(), samples.end(),
                                  [](const Sample& s) { return s.hollow != HollowReading{}; });
  if (hollow) {
    return kVersionHollow;
  }
  const bool arrived = std::any_of(samples.begin(), samples.end(),
                                   [](const Sample& s) { return s.async.state != AsyncState::kNothing; });
  return arrived ? kVersionAsync : kVersion;
}

std::vector<std::uint8_t> packColumns(std::span<const Sample> samples, std::size_t columns) {
  std::vector<Row> rows;
  rows.reserve(samples.size());
  for (const Sample& sample : samples) {
    rows.push_back(toRow(sample));
  }
  std::vector<std::uint8_t> packed;
  std::vector<std::int64_t> column(samples.size());
  for (std::size_t c = 0; c < columns; ++c) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      column[i] = rows[i][c];
    }
    packColumn(column, packed);
  }
  return packed;
}

std::vector<std::uint8_t> decompress(std::span<const std::byte> frame, std::size_t samples) {
  // The most that `samples` rows can take, so that damaged sizes cannot ask for all memory.
  const std::size_t largest = kColumns * largestPackedColumn(samples);
  const unsigned long long size = ZSTD_getFrameContentSize(frame.data(), frame.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN || size > largest) {
    damaged(Text::verbatim("the size of the packed samples is impossible"));
  }
  std::vector<std::uint8_t> packed(static_cast<std::size_t>(size));
  const std::size_t written = ZSTD_decompress(packed.data(), packed.size(), frame.data(), frame.size());
  if (ZSTD_isError(written) != 0U || written != packed.size()) {
    damaged(Text::verbatim("the packed samples do not unpack"));
  }
  return packed;
}

}  // namespace

TrialChunk encodeChunk(std::int64_t index, std::span<const Sample> samples) {
  TORSIO_EXPECTS(!samples.empty() && samples.size() <= static_cast<std::size_t>(kLargestChunk));
  const std::uint8_t version = versionFor(samples);
  const std::vector<std::uint8_t> packed = packColumns(samples, columnsOf(version));

  TrialChunk chunk;
  chunk.index = index;
  chunk.firstTick = samples.front().tick;
  chunk.samples = static_cast<std::int64_t>(samples.size());
  chunk.bytes.resize(kHeaderSize + ZSTD_compressBound(packed.size()));
  for (std::size_t i = 0; i < kChunkMagic.size(); ++i) {
    chunk.bytes[i] = std::byte{kChunkMagic[i]};
  }
  chunk.bytes[kChunkMagic.size()] = std::byte{version};

  ZSTD_CCtx* const context = ZSTD_createCCtx();
  TORSIO_EXPECTS(context != nullptr);
  ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, kCompressionLevel);
  ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
  const std::size_t size = ZSTD_compress2(context, chunk.bytes.data() + kHeaderSize,
                                          chunk.bytes.size() - kHeaderSize, packed.data(), packed.size());
  ZSTD_freeCCtx(context);
  TORSIO_EXPECTS(ZSTD_isError(size) == 0U);
  chunk.bytes.resize(kHeaderSize + size);
  chunk.bytes.shrink_to_fit();
  chunk.digest = chunkDigest(chunk);
  chunk.outputDigest = outputDigest(samples);
  return chunk;
}

std::vector<Sample> decodeChunk(const TrialChunk& chunk) {
  if (chunk.samples < 1 || chunk.samples > kLargestChunk) {
    damaged(Text::verbatim("the number of samples is impossible"));
  }
  if (chunkDigest(chunk) != chunk.digest) {
    damaged(Text::verbatim("the bytes do not match their digest"));
  }
  const std::span<const std::byte> bytes(chunk.bytes);
  if (bytes.size() < kHeaderSize ||
      !std::equal(kChunkMagic.begin(), kChunkMagic.end(), bytes.begin(),
                  [](std::uint8_t a, std::byte b) { return std::byte{a} == b; })) {
    damaged(Text::verbatim("this is not a chunk of samples"));
  }
  const auto version = std::to_integer<std::uint8_t>(bytes[kChunkMagic.size()]);
  if (version < kVersion || version > kVersionHollow) {
    throw Error(ErrorCode::kBadData, Text::verbatim("the samples were written in another format version"),
                Text::verbatim("recorded chunk"),
                Text::verbatim("Open the run with the version that wrote it, or a newer one"));
  }
  const auto count = static_cast<std::size_t>(chunk.samples);
  const std::vector<std::uint8_t> packed = decompress(bytes.subspan(kHeaderSize), count);

  std::vector<Row> rows(count);
  std::vector<std::int64_t> column(count);
  std::span<const std::uint8_t> rest(packed);
  for (std::size_t c = 0; c < columnsOf(version); ++c) {
    rest = unpackColumn(rest, column);
    for (std::size_t i = 0; i < count; ++i) {
      rows[i][c] = column[i];
    }
  }
  if (!rest.empty()) {
    damaged(Text::verbatim("bytes follow after the last column"));
  }

  std::vector<Sample> samples;
  samples.reserve(count);
  for (const Row& row : rows) {
    if (!samples.empty() && row[kTick] <= samples.back().tick) {
      damaged(Text::verbatim("the ticks do not increase"));
    }
    samples.push_back(toSample(row));
  }
  if (samples.front().tick != chunk.firstTick) {
    damaged(Text::verbatim("the first tick is another one"));
  }
  return samples;
}

std::vector<Sample> decodeTrial(const Trial& trial) {
  std::vector<Sample> all;
  std::int64_t expected = 0;
  for (const TrialChunk& chunk : trial.chunks) {
    if (chunk.index != expected++) {
      damaged(Text::verbatim("a chunk is missing or out of order"));
    }
    const std::vector<Sample> samples = decodeChunk(chunk);
    if (!all.empty() && samples.front().tick <= all.back().tick) {
      damaged(Text::verbatim("the ticks do not increase"));
    }
    all.insert(all.end(), samples.begin(), samples.end());
  }
  return all;
}

Sample inStoredSteps(const Sample& sample) noexcept {
  Sample stored = sample;
  answersFromRow(toRow(sample), stored);
  return stored;
}

std::string chunkDigest(const TrialChunk& chunk) {
  Digest digest;
  digest.update(chunk.index);
  digest.update(chunk.firstTick);
  digest.update(chunk.samples);
  digest.update(std::span<const std::byte>(chunk.bytes));
  return digest.hex();
}

std::string outputDigest(std::span<const Sample> samples) {
  Digest digest;
  for (const Sample& s : samples) {
    for (const double value : {s.response.angle_rad, s.response.torque_Nm, s.response.force_N.x,
                               s.response.force_N.y, s.response.force_N.z, s.response.depth_m,
                               s.response.graspArc_m, s.force_N.x, s.force_N.y, s.force_N.z}) {
      digest.update(value);
    }
    if (areOfDetorsion(s.rules)) {
      for (const double value : {s.hollow.pressure_Pa, s.hollow.patency, s.hollow.flow, s.hollow.dose}) {
        digest.update(value);
      }
    }
  }
  return digest.hex();
}

}  // namespace torsio
