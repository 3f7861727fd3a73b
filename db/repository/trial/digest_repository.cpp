// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/digest_repository.h"

#include <bit>
#include <limits>

#include "db/connection/row_reader.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

static_assert(std::numeric_limits<double>::is_iec559);
constexpr std::size_t kNumberBytes = 8;
constexpr std::size_t kAttemptBytes = kNumberBytes + 1;

Blob packed(const std::vector<std::pair<double, bool>>& attempts) {
  Blob bytes;
  bytes.reserve(attempts.size() * kAttemptBytes);
  for (const auto& [error_deg, onTarget] : attempts) {
    const auto bits = std::bit_cast<std::uint64_t>(error_deg);
    for (std::size_t i = 0; i < kNumberBytes; ++i) bytes.push_back(static_cast<std::byte>(bits >> (8 * i)));
    bytes.push_back(onTarget ? std::byte{1} : std::byte{0});
  }
  return bytes;
}

std::vector<std::pair<double, bool>> unpacked(const Blob& bytes, const std::string& trialId) {
  if (bytes.size() % kAttemptBytes != 0)
    throw Error(ErrorCode::kBadData, "the digest of a recording is cut off", trialId,
                "Check the database, and restore a backup");
  std::vector<std::pair<double, bool>> attempts;
  attempts.reserve(bytes.size() / kAttemptBytes);
  for (std::size_t at = 0; at < bytes.size(); at += kAttemptBytes) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < kNumberBytes; ++i)
      bits |= std::to_integer<std::uint64_t>(bytes[at + i]) << (8 * i);
    attempts.emplace_back(std::bit_cast<double>(bits), bytes[at + kNumberBytes] != std::byte{0});
  }
  return attempts;
}

}  // namespace

void DigestRepository::add(std::span<const StoredTrialDigest> digests) {
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(
      insertInto("trial_digest",
                 "trial_id, formula_version, tolerance_rad, content_hash, model, minutes,"
                 " mean_absolute_error_deg, peak_torque_nm, peak_force_n, attempts, computed_utc_us") +
      " ON CONFLICT (trial_id, formula_version, tolerance_rad) DO NOTHING");
  for (const StoredTrialDigest& digest : digests) {
    insert.execute({digest.trialId, digest.formulaVersion, digest.tolerance_rad, digest.contentHash,
                    digest.model, digest.minutes, digest.meanAbsoluteError_deg, digest.peakTorque_Nm,
                    digest.peakForce_N, packed(digest.attempts), digest.computedUtc_us});
  }
  transaction.commit();
}

std::multimap<std::string, StoredTrialDigest> DigestRepository::ofCohort(
    const std::string& cohortId, const std::string& formulaVersion) const {
  Statement row = connection_.prepare(
      "SELECT d.trial_id, d.formula_version, d.tolerance_rad, d.content_hash, d.model, d.minutes,"
      " d.mean_absolute_error_deg, d.peak_torque_nm, d.peak_force_n, d.attempts, d.computed_utc_us"
      " FROM enrolment e JOIN trial t ON t.enrolment_id = e.id"
      " JOIN trial_digest d ON d.trial_id = t.id AND d.formula_version = ? WHERE e.cohort_id = ?");
  row.execute({formulaVersion, cohortId});
  std::multimap<std::string, StoredTrialDigest> digests;
  while (row.step()) {
    StoredTrialDigest digest{.trialId = row.text(0),
                             .formulaVersion = row.text(1),
                             .tolerance_rad = row.real(2),
                             .contentHash = row.text(3),
                             .model = row.text(4),
                             .minutes = row.real(5),
                             .meanAbsoluteError_deg = row.maybeReal(6),
                             .peakTorque_Nm = row.maybeReal(7),
                             .peakForce_N = row.maybeReal(8),
                             .attempts = unpacked(row.blob(9), row.text(0)),
                             .computedUtc_us = row.int64(10)};
    std::string id = digest.trialId;
    digests.emplace(std::move(id), std::move(digest));
  }
  return digests;
}

std::string DigestRepository::cohortOf(const std::string& enrolmentId) const {
  Statement row = connection_.prepare("SELECT cohort_id FROM enrolment WHERE id = ?");
  row.execute({enrolmentId});
  std::string cohortId;
  while (row.step()) cohortId = row.text(0);
  return cohortId;
}

}  // namespace torsio
