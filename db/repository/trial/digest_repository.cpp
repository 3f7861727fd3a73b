// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/digest_repository.h"

#include <bit>
#include <limits>

#include "assessment/domain/ids.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/learning_events.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

static_assert(std::numeric_limits<double>::is_iec559);
constexpr std::size_t kNumberBytes = 8;
constexpr std::size_t kAttemptBytes = kNumberBytes + 1;
constexpr std::size_t kLongestId = 255;
constexpr double kNoLimit = -1.0;

[[noreturn]] void refuseCutOff(const TrialId& trialId) {
  refuse(Text::tr("the digest of a recording is cut off"), trialId,
         Text::tr("Check the database, and restore a backup"));
}

void appendNumber(Blob& bytes, double number) {
  const auto bits = std::bit_cast<std::uint64_t>(number);
  for (std::size_t i = 0; i < kNumberBytes; ++i) {
    bytes.push_back(static_cast<std::byte>(bits >> (8 * i)));
  }
}

double numberAt(const Blob& bytes, std::size_t at) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < kNumberBytes; ++i) {
    bits |= std::to_integer<std::uint64_t>(bytes[at + i]) << (8 * i);
  }
  return std::bit_cast<double>(bits);
}

Blob packed(const std::vector<JudgedTwist>& twists) {
  Blob bytes;
  bytes.reserve(twists.size() * kAttemptBytes);
  for (const JudgedTwist& twist : twists) {
    appendNumber(bytes, twist.error_deg);
    bytes.push_back(twist.onTarget ? std::byte{1} : std::byte{0});
  }
  return bytes;
}

std::vector<JudgedTwist> twistsFrom(const Blob& bytes, const TrialId& trialId) {
  if (bytes.size() % kAttemptBytes != 0) {
    refuseCutOff(trialId);
  }
  std::vector<JudgedTwist> twists;
  twists.reserve(bytes.size() / kAttemptBytes);
  for (std::size_t at = 0; at < bytes.size(); at += kAttemptBytes) {
    twists.push_back({numberAt(bytes, at), bytes[at + kNumberBytes] != std::byte{0}});
  }
  return twists;
}

/// Packs the values by stored id, in the order of these.
Blob packed(const QuantityValues& values) {
  std::map<std::string, double> byId;
  for (const auto& [quantity, value] : values) {
    byId.emplace(idOf(quantity), value);
  }
  Blob bytes;
  for (const auto& [id, value] : byId) {
    TORSIO_EXPECTS(id.size() <= kLongestId);
    bytes.push_back(static_cast<std::byte>(id.size()));
    for (const char letter : id) {
      bytes.push_back(static_cast<std::byte>(letter));
    }
    appendNumber(bytes, value);
  }
  return bytes;
}

/// Omits quantities that this version does not know.
QuantityValues valuesFrom(const Blob& bytes, const TrialId& trialId) {
  QuantityValues values;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto length = std::to_integer<std::size_t>(bytes[at]);
    ++at;
    if (bytes.size() - at < length + kNumberBytes) {
      refuseCutOff(trialId);
    }
    std::string id;
    for (std::size_t i = 0; i < length; ++i) {
      id.push_back(static_cast<char>(bytes[at + i]));
    }
    if (const std::optional<Quantity> quantity = quantityOf(id)) {
      values[*quantity] = numberAt(bytes, at + length);
    }
    at += length + kNumberBytes;
  }
  return values;
}

/// Returns a peak as its column holds it: of runs with a completed twist.
std::optional<double> peakOf(const AttemptMeasures& measures, Quantity quantity) {
  return measures.twists.empty() ? std::nullopt : valueIn(measures.values, quantity);
}

std::optional<double> limitFrom(double stored) {
  return stored >= 0.0 ? std::optional(stored) : std::nullopt;
}

constexpr const char* kColumns =
    "d.trial_id, d.formula_version, d.tolerance_rad, d.force_limit_n, d.torque_limit_nm, d.content_hash,"
    " d.model, d.duration_us, d.unfinished_twists, d.mean_absolute_error_deg, d.attempts,"
    " d.measures, d.computed_utc_us";

TrialDigest digestFrom(RowReader& row) {
  TrialDigest digest;
  digest.trialId = row.text();
  digest.formulaVersion = row.int64();
  digest.tolerance_rad = row.real();
  digest.forceLimit_N = limitFrom(row.real());
  digest.torqueLimit_Nm = limitFrom(row.real());
  digest.contentHash = row.text();
  digest.model = row.text();
  digest.measures.duration_us = row.int64();
  digest.measures.unfinished = row.int64();
  digest.measures.meanAbsoluteError_deg = row.maybeReal();
  digest.measures.twists = twistsFrom(row.blob(), digest.trialId);
  digest.measures.values = valuesFrom(row.blob(), digest.trialId);
  digest.computedUtc_us = row.int64();
  return digest;
}

}  // namespace

void DigestRepository::add(std::span<const TrialDigest> digests) {
  std::vector<std::string> judged;
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(
      insertInto("trial_digest",
                 "trial_id, formula_version, tolerance_rad, force_limit_n, torque_limit_nm, content_hash,"
                 " model, duration_us, unfinished_twists, mean_absolute_error_deg, peak_torque_nm,"
                 " peak_force_n, attempts, measures, computed_utc_us") +
      " ON CONFLICT (trial_id, formula_version, tolerance_rad, force_limit_n, torque_limit_nm) DO NOTHING");
  for (const TrialDigest& digest : digests) {
    const AttemptMeasures& measures = digest.measures;
    insert.execute({digest.trialId, digest.formulaVersion, digest.tolerance_rad,
                    digest.forceLimit_N.value_or(kNoLimit), digest.torqueLimit_Nm.value_or(kNoLimit),
                    digest.contentHash, digest.model, measures.duration_us, measures.unfinished,
                    measures.meanAbsoluteError_deg, peakOf(measures, Quantity::kPeakTorque),
                    peakOf(measures, Quantity::kPeakForce), packed(measures.twists), packed(measures.values),
                    digest.computedUtc_us});
    judged.push_back(digest.trialId);
  }
  noteLearningEvents(connection_, LearningEventKind::kJudged, judged);
  transaction.commit();
}

std::multimap<std::string, TrialDigest> DigestRepository::ofCohort(const CohortId& cohortId,
                                                                   std::int64_t formulaVersion) const {
  std::multimap<std::string, TrialDigest> digests;
  for (TrialDigest& digest :
       selectAll(connection_,
                 std::string("SELECT ") + kColumns +
                     " FROM enrolment e JOIN trial t ON t.enrolment_id = e.id"
                     " JOIN trial_digest d ON d.trial_id = t.id AND d.formula_version = ?"
                     " WHERE e.cohort_id = ?",
                 {formulaVersion, cohortId}, digestFrom)) {
    std::string id = digest.trialId;
    digests.emplace(std::move(id), std::move(digest));
  }
  return digests;
}

std::vector<TrialDigest> DigestRepository::ofTrial(const TrialId& trialId,
                                                   std::int64_t formulaVersion) const {
  return selectAll(connection_,
                   std::string("SELECT ") + kColumns +
                       " FROM trial_digest d WHERE d.trial_id = ? AND d.formula_version = ?",
                   {trialId, formulaVersion}, digestFrom);
}

std::vector<TrialDigest> DigestRepository::olderOfTrial(const TrialId& trialId,
                                                        std::int64_t formulaVersion) const {
  return selectAll(connection_,
                   std::string("SELECT ") + kColumns +
                       " FROM trial_digest d WHERE d.trial_id = ? AND d.formula_version < ?"
                       " ORDER BY d.formula_version DESC",
                   {trialId, formulaVersion}, digestFrom);
}

}  // namespace torsio
