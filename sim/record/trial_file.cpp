// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/record/trial_file.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/record/content_hash.h"

namespace torsio {

namespace {

constexpr std::string_view kMagic = "TORSIO TRIAL 1\n";
enum class RecordKind : char { kHeader = 'H', kContext = 'X', kChunk = 'C', kSummary = 'S' };
constexpr std::size_t kLengthSize = 8;
constexpr std::size_t kDigestSize = sizeof(Digest::Value);

Digest::Value recordDigest(RecordKind kind, std::span<const std::byte> payload) {
  Digest digest;
  digest.update(static_cast<std::int64_t>(kind));
  digest.update(payload);
  return digest.value();
}

/// Kind, length, payload, digest.
std::string record(RecordKind kind, const std::vector<std::byte>& payload) {
  std::string bytes(1, static_cast<char>(kind));
  for (unsigned i = 0; i < kLengthSize; ++i) {
    bytes.push_back(static_cast<char>((static_cast<std::uint64_t>(payload.size()) >> (8 * i)) & 0xFFU));
  }
  bytes.append(reinterpret_cast<const char*>(payload.data()), payload.size());
  for (const std::uint8_t byte : recordDigest(kind, payload)) {
    bytes.push_back(static_cast<char>(byte));
  }
  return bytes;
}

struct Record {
  RecordKind kind = RecordKind::kHeader;
  std::span<const std::byte> payload;
};

/// The record at the front of `rest`, which is moved on; nothing when it was cut off.
std::optional<Record> takeRecord(std::span<const std::byte>& rest, const std::filesystem::path& file) {
  if (rest.size() < 1 + kLengthSize) {
    return std::nullopt;
  }
  std::uint64_t length = 0;
  for (unsigned i = 0; i < kLengthSize; ++i) {
    length |= static_cast<std::uint64_t>(rest[1 + i]) << (8 * i);
  }
  const std::span<const std::byte> body = rest.subspan(1 + kLengthSize);
  if (body.size() < kDigestSize || length > body.size() - kDigestSize) {
    return std::nullopt;
  }
  Record found;
  found.kind = static_cast<RecordKind>(rest[0]);
  found.payload = body.first(static_cast<std::size_t>(length));
  const Digest::Value digest = recordDigest(found.kind, found.payload);
  const auto stored = body.subspan(found.payload.size(), kDigestSize);
  for (std::size_t i = 0; i < kDigestSize; ++i) {
    if (stored[i] != std::byte{digest[i]}) {
      throw Error(ErrorCode::kBadData, Text::verbatim("a record does not match its digest"), file.string(),
                  Text::verbatim("The file is damaged: restore it from a copy"));
    }
  }
  rest = body.subspan(found.payload.size() + kDigestSize);
  return found;
}

}  // namespace

TrialFileSink::TrialFileSink(std::filesystem::path file, std::string context)
    : file_(std::move(file)), context_(std::move(context)) {}

void TrialFileSink::write(const std::string& bytes) {
  if (!out_.is_open()) {
    out_.open(temporaryBeside(file_), std::ios::binary | std::ios::in | std::ios::ate);
  }
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out_.flush();
  if (out_) {
    sound_ += bytes.size();
    return;
  }
  // Half a record must not stand before the next attempt.
  out_.clear();
  out_.close();
  std::error_code ignored;
  std::filesystem::resize_file(temporaryBeside(file_), sound_, ignored);
  throw Error(ErrorCode::kFileUnwritable, Text::verbatim("the trial cannot be written"), file_.string(),
              Text::tr("Check that the folder exists, is not read-only, and that the disk is not full"));
}

void TrialFileSink::begin(const TrialHeader& header) {
  out_ = std::ofstream(temporaryBeside(file_), std::ios::binary | std::ios::trunc);
  sound_ = 0;
  std::string bytes = std::string(kMagic) + record(RecordKind::kHeader, toBytes(header));
  if (!context_.empty()) {
    const auto text = std::as_bytes(std::span(context_));
    bytes += record(RecordKind::kContext, {text.begin(), text.end()});
  }
  write(bytes);
}

void TrialFileSink::append(const TrialChunk& chunk) {
  write(record(RecordKind::kChunk, toBytes(chunk)));
}

void TrialFileSink::finish(const TrialSummary& summary) {
  write(record(RecordKind::kSummary, toBytes(summary)));
  out_.close();
  std::error_code failed;
  std::filesystem::rename(temporaryBeside(file_), file_, failed);
  if (failed) {
    throw Error(ErrorCode::kFileUnwritable, Text::verbatim("the finished trial cannot be renamed"),
                file_.string(), Text::verbatim("Rename the file that ends in .part by hand"));
  }
}

TrialFile openTrialFile(const std::filesystem::path& file) {
  const std::string content = readFile(file);
  if (content.substr(0, kMagic.size()) != kMagic) {
    throw Error(ErrorCode::kFileUnreadable, Text::verbatim("this is not a trial file"), file.string(),
                Text::verbatim("Choose a file that Torsio recorded or exported"));
  }
  const auto broken = [&file](Phrase what) {
    throw Error(ErrorCode::kBadData, what, file.string(),
                Text::verbatim("The file is damaged: restore it from a copy"));
  };
  std::span<const std::byte> rest = std::as_bytes(std::span(content)).subspan(kMagic.size());
  TrialFile read;
  Trial& trial = read.trial;
  bool begun = false;
  while (const std::optional<Record> next = takeRecord(rest, file)) {
    if (read.finished || begun == (next->kind == RecordKind::kHeader)) {
      broken(Text::verbatim("the records are out of order"));
    }
    switch (next->kind) {
      case RecordKind::kHeader:
        trial.header = fromBytes<TrialHeader>(next->payload);
        begun = true;
        break;
      case RecordKind::kContext:
        read.context.assign(reinterpret_cast<const char*>(next->payload.data()), next->payload.size());
        break;
      case RecordKind::kChunk:
        trial.chunks.push_back(fromBytes<TrialChunk>(next->payload));
        break;
      case RecordKind::kSummary:
        trial.summary = fromBytes<TrialSummary>(next->payload);
        read.finished = true;
        break;
      default:
        broken(Text::verbatim("an unknown record"));
    }
  }
  if (!begun) {
    broken(Text::verbatim("the file ends before the trial begins"));
  }
  if (read.finished && !rest.empty()) {
    broken(Text::verbatim("bytes follow after the end of the trial"));
  }
  if (!read.finished) {
    trial.summary.outcome = TrialOutcome::kInterrupted;
    for (const TrialChunk& chunk : trial.chunks) {
      trial.summary.samples += chunk.samples;
    }
    trial.summary.contentHash = contentHash(trial);
  }
  return read;
}

Trial readTrialFile(const std::filesystem::path& file) {
  return openTrialFile(file).trial;
}

}  // namespace torsio
