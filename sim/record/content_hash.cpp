// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/record/content_hash.h"

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

[[noreturn]] void damaged() {
  throw Error(ErrorCode::kBadData, Text::verbatim("the bytes of a trial do not read"),
              Text::verbatim("recorded trial"),
              Text::verbatim("The recording is damaged: restore it from a copy"));
}

/// One visit function a type serves both directions, so that they cannot disagree.
class Writer {
 public:
  std::vector<std::byte> bytes;

  /// Tells whether something optional follows: when there is something to say.
  [[nodiscard]] static bool goesOn(bool said) { return said; }
  template <typename T>
  [[nodiscard]] static const T& part(const std::optional<T>& whole) {
    return *whole;
  }
  void number(std::int64_t value) {
    for (unsigned i = 0; i < 8; ++i) {
      bytes.push_back(static_cast<std::byte>((static_cast<std::uint64_t>(value) >> (8 * i)) & 0xFFU));
    }
  }
  void operator()(const std::int64_t& value) { number(value); }
  void operator()(const double& value) { number(std::bit_cast<std::int64_t>(value)); }
  void operator()(const bool& value) { number(value ? 1 : 0); }
  void operator()(const std::string& text) {
    number(static_cast<std::int64_t>(text.size()));
    const auto raw = std::as_bytes(std::span(text));
    bytes.insert(bytes.end(), raw.begin(), raw.end());
  }
  void operator()(const std::vector<std::byte>& raw) {
    number(static_cast<std::int64_t>(raw.size()));
    bytes.insert(bytes.end(), raw.begin(), raw.end());
  }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void operator()(const Enum& value, Enum) { number(static_cast<std::int64_t>(value)); }
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

  /// Tells whether something optional follows: when there are bytes left.
  [[nodiscard]] bool goesOn(bool) const { return !rest_.empty(); }
  template <typename T>
  [[nodiscard]] static T& part(std::optional<T>& whole) {
    return whole.emplace();
  }
  void operator()(std::int64_t& value) { value = number(); }
  void operator()(double& value) {
    value = std::bit_cast<double>(number());
    if (!std::isfinite(value)) {
      damaged();
    }
  }
  void operator()(bool& value) {
    const std::int64_t bit = number();
    if (bit != 0 && bit != 1) {
      damaged();
    }
    value = bit == 1;
  }
  void operator()(std::string& text) {
    const std::span<const std::byte> raw = block();
    text.assign(reinterpret_cast<const char*>(raw.data()), raw.size());
  }
  template <typename Tag>
  void operator()(Id<Tag>& id) {
    std::string text;
    (*this)(text);
    id = std::move(text);
  }
  void operator()(std::vector<std::byte>& raw) {
    const std::span<const std::byte> found = block();
    raw.assign(found.begin(), found.end());
  }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void operator()(Enum& value, Enum last) {
    const std::int64_t found = number();
    if (found < 0 || found > static_cast<std::int64_t>(last)) {
      damaged();
    }
    value = static_cast<Enum>(found);
  }
  void end() const {
    if (!rest_.empty()) {
      damaged();
    }
  }

 private:
  std::int64_t number() {
    if (rest_.size() < 8) {
      damaged();
    }
    std::uint64_t value = 0;
    for (unsigned i = 0; i < 8; ++i) {
      value |= static_cast<std::uint64_t>(rest_[i]) << (8 * i);
    }
    rest_ = rest_.subspan(8);
    return static_cast<std::int64_t>(value);
  }
  std::span<const std::byte> block() {
    const std::int64_t size = number();
    if (size < 0 || static_cast<std::uint64_t>(size) > rest_.size()) {
      damaged();
    }
    const auto found = rest_.first(static_cast<std::size_t>(size));
    rest_ = rest_.subspan(found.size());
    return found;
  }

  std::span<const std::byte> rest_;
};

/// The part itself to be read, or a constant one to be written.
template <typename Part, typename Of>
concept EitherConst = std::same_as<std::remove_const_t<Part>, Of>;

template <typename Visitor, typename Limits>
void visitLimits(Visitor& visit, Limits& limits) {
  visit(limits.maxForce_N);
  visit(limits.continuousForce_N);
  visit(limits.maxStiffness_N_per_m);
  for (auto* corner : {&limits.workspaceMin_m, &limits.workspaceMax_m}) {
    visit(corner->x);
    visit(corner->y);
    visit(corner->z);
  }
}

template <typename Visitor, EitherConst<TrialHeader> Header>
void fieldsOf(Visitor& visit, Header& header) {
  visit(header.trialId);
  visit(header.traineeCode);
  visit(header.sceneId);
  visit(header.patternId);
  visit(header.organHash);
  visit(header.parameterHash);
  visit(header.parametersJson);
  visit(header.deviceModel);
  visitLimits(visit, header.deviceLimits);
  visit(header.softwareVersion);
  visit(header.phaseLabel);
  visit(header.drive, TwistDrive::kRoll);
  visit(header.targetAngle_rad);
  visit(header.forceScale);
  visit(header.tickPeriod_us);
  visit(header.startedUtc_us);
  visit(header.demonstration);
  // Trials from before there were other models know of none: the usual one goes unsaid, so that their hashes
  // stay true.
  if (visit.goesOn(header.model != TissueModel::kTwist)) {
    visit(header.model, TissueModel::kMassSpring);
  }
}

template <typename Visitor, EitherConst<TrialChunk> Chunk>
void fieldsOf(Visitor& visit, Chunk& chunk) {
  visit(chunk.index);
  visit(chunk.firstTick);
  visit(chunk.samples);
  visit(chunk.bytes);
  visit(chunk.digest);
  visit(chunk.outputDigest);
}

template <typename Visitor, EitherConst<TrialSummary> Summary>
void fieldsOf(Visitor& visit, Summary& summary) {
  visit(summary.samples);
  visit(summary.refusedSamples);
  visit(summary.lateTicks);
  visit(summary.outcome, TrialOutcome::kInterrupted);
  visit(summary.contentHash);
  // Trials that did not run in real time say nothing of it.
  if (visit.goesOn(summary.health.has_value())) {
    auto& health = visit.part(summary.health);
    visit(health.priority);
    visit(health.memory);
    visit(health.skippedTicks);
    visit(health.forceCuts);
  }
}

[[noreturn]] void unfit(const Text& what, const Trial& trial) {
  throw Error(ErrorCode::kVerifyFailed, what, Text::tr("run %1", trial.header.trialId),
              Text::verbatim("Do not use this run for scoring: it is not what was recorded"));
}

}  // namespace

template <typename Part>
std::vector<std::byte> toBytes(const Part& part) {
  Writer writer;
  fieldsOf(writer, part);
  return std::move(writer.bytes);
}

template <typename Part>
Part fromBytes(std::span<const std::byte> bytes) {
  Reader reader(bytes);
  Part part;
  fieldsOf(reader, part);
  reader.end();
  return part;
}

template std::vector<std::byte> toBytes(const TrialHeader&);
template std::vector<std::byte> toBytes(const TrialChunk&);
template std::vector<std::byte> toBytes(const TrialSummary&);
template TrialHeader fromBytes(std::span<const std::byte>);
template TrialChunk fromBytes(std::span<const std::byte>);
template TrialSummary fromBytes(std::span<const std::byte>);

ContentHash::ContentHash(const TrialHeader& header) {
  Digest digest;
  digest.update(std::span<const std::byte>(toBytes(header)));
  link_ = digest.hex();
}

void ContentHash::add(const TrialChunk& chunk) {
  Digest digest;
  digest.update(link_);
  digest.update(chunk.digest);
  digest.update(chunk.outputDigest);
  link_ = digest.hex();
}

std::string contentHash(const Trial& trial) {
  ContentHash hash(trial.header);
  for (const TrialChunk& chunk : trial.chunks) {
    hash.add(chunk);
  }
  return hash.hex();
}

void verifyContent(const Trial& trial) {
  std::int64_t samples = 0;
  for (const TrialChunk& chunk : trial.chunks) {
    if (chunkDigest(chunk) != chunk.digest) {
      unfit(Text::verbatim("chunk %1 does not match its digest", std::to_string(chunk.index)), trial);
    }
    samples += chunk.samples;
  }
  if (contentHash(trial) != trial.summary.contentHash) {
    unfit(Text::verbatim("the content hash does not match"), trial);
  }
  if (samples != trial.summary.samples) {
    unfit(Text::verbatim("the number of samples does not match"), trial);
  }
}

}  // namespace torsio
