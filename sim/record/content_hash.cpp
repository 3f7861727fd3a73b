// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/record/content_hash.h"

#include <span>

#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial_bytes.h"

namespace torsio {

namespace {

[[noreturn]] void unfit(const Text& what, const Trial& trial) {
  throw Error(ErrorCode::kVerifyFailed, what, Text::tr("run %1", trial.header.trialId),
              Text::verbatim("Do not use this run for scoring: it is not what was recorded"));
}

}  // namespace

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
