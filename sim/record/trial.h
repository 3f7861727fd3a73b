// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/live_types.h"
#include "sim/core/servo_health.h"
#include "sim/core/time_units.h"
#include "sim/core/tissue_model.h"

namespace torsio {

/// Limits of the device that the force governor keeps: part of the trial, because they shape the recorded
/// force. The defaults are those of a device without limits of its own (nominal values of a Touch, no
/// workspace box).
struct DeviceLimits {
  double maxForce_N = 3.3;  ///< norm, short bursts
  double continuousForce_N = 0.88;
  double maxStiffness_N_per_m = 500.0;
  Vec3 workspaceMin_m{-10.0, -10.0, -10.0};  ///< usable box, world frame
  Vec3 workspaceMax_m{10.0, 10.0, 10.0};
  friend bool operator==(const DeviceLimits&, const DeviceLimits&) = default;
};

/// Everything that must be known to replay a trial, stored before the first sample.
struct TrialHeader {
  TrialId trialId;          ///< UUID made by the application
  std::string traineeCode;  ///< pseudonym, never a name
  SceneId sceneId;
  PatternId patternId;
  std::string organHash;
  std::string parameterHash;
  std::string parametersJson;
  std::string deviceModel;
  DeviceLimits deviceLimits;
  std::string softwareVersion;
  std::string phaseLabel;  ///< "virtual 0-20 min" ...; empty for free practice
  TwistDrive drive = TwistDrive::kTangential;
  double targetAngle_rad = 0.0;
  double forceScale = 1.0;
  std::int64_t tickPeriod_us = kTickPeriod_us;
  std::int64_t startedUtc_us = 0;
  bool demonstration = false;               ///< simulated people: shown as such everywhere
  TissueModel model = TissueModel::kTwist;  ///< that answered the hand; physicians never learn it
  /// Seed of the trial where trialId was taken out (blinding); else it follows from trialId. In memory only:
  /// no part of what is stored or hashed.
  std::optional<std::uint64_t> seed{};
  friend bool operator==(const TrialHeader&, const TrialHeader&) = default;
};

/// One second of samples, encoded (sample_codec.h). Immutable once made.
struct TrialChunk {
  std::int64_t index = 0;
  std::int64_t firstTick = 0;
  std::int64_t samples = 0;
  std::vector<std::byte> bytes;  ///< integers, delta, byte shuffle, zstd
  std::string digest;            ///< BLAKE2b-256 over index, firstTick, samples and bytes
  std::string outputDigest;      ///< over the exact doubles that the model answered: the bit-for-bit check
};

enum class TrialOutcome : std::uint8_t { kCompleted, kInterrupted };

/// What is known of a trial at its end, stored after the last sample.
struct TrialSummary {
  std::int64_t samples = 0;
  std::int64_t refusedSamples = 0;  ///< not recorded because the ring was full; 0 in a sound trial
  std::int64_t lateTicks = 0;
  TrialOutcome outcome = TrialOutcome::kCompleted;
  std::string contentHash;              ///< chain over header and all chunk digests
  std::optional<ServoHealth> health{};  ///< empty: not run in real time
};

/// A recorded trial as plain values.
struct Trial {
  TrialHeader header;
  std::vector<TrialChunk> chunks;
  TrialSummary summary;
};

/// Where a recording goes. The recorder's thread calls the functions in the order given, each once except
/// append. Throws Error when it cannot keep what it was given; the recorder then retries and spills.
class TrialSink {
 public:
  virtual ~TrialSink() = default;
  virtual void begin(const TrialHeader& header) = 0;
  virtual void append(const TrialChunk& chunk) = 0;
  virtual void finish(const TrialSummary& summary) = 0;
};

/// Returns the seed of a trial: the twist that a hollow organ comes with and the errors of checks hang on it.
/// Of no id the same one always. Any thread.
[[nodiscard]] std::uint64_t detorsionSeed(const TrialId& trialId) noexcept;

/// Where a recording goes when its sink gives up, and the context that is written with it.
struct SpillPlace {
  std::filesystem::path folder;  ///< made when needed
  std::string context;           ///< readable text that complements the header
};

/// A sink that knows its spill place. For any other sink the recorder's options decide.
class SpillingTrialSink : public TrialSink {
 public:
  /// Returns the place. Called in the recorder's thread, after this sink has failed.
  [[nodiscard]] virtual SpillPlace spillPlace() const = 0;
};

/// Keeps a recording in memory: for replay right after the trial, and for tests.
class MemoryTrialSink final : public TrialSink {
 public:
  void begin(const TrialHeader& header) override {
    trial_ = {};
    trial_.header = header;
    trial_.summary.outcome = TrialOutcome::kInterrupted;
  }
  void append(const TrialChunk& chunk) override { trial_.chunks.push_back(chunk); }
  void finish(const TrialSummary& summary) override { trial_.summary = summary; }

  /// Returns the trial as far as it was recorded; its outcome is interrupted until finish().
  [[nodiscard]] const Trial& trial() const noexcept { return trial_; }

 private:
  Trial trial_;
};

}  // namespace torsio
