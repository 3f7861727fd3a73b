// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/seals.h"

#include <algorithm>
#include <vector>

#include "db/repository/base/field_digest.h"

namespace torsio {

namespace {

constexpr std::size_t kBatch = 500;  // placeholders a statement; SQLite allows 32766

/// Calls `read` for every row of `sql` whose `column` is one of `ids`, or for all rows when there are none.
template <typename Read>
void forEachRow(Connection& connection, const std::string& sql, const std::string& column,
                std::span<const std::string> ids, const std::string& order, Read&& read) {
  std::size_t done = 0;
  do {
    const std::span<const std::string> batch = ids.subspan(done, std::min(kBatch, ids.size() - done));
    std::string where;
    for (std::size_t i = 0; i < batch.size(); ++i) where += i == 0 ? "?" : ", ?";
    if (!where.empty()) where = " WHERE " + column + " IN (" + where + ")";
    Statement row = connection.prepare(sql + where + " ORDER BY " + order);
    row.execute(std::vector<Value>(batch.begin(), batch.end()));
    while (row.step()) read(row);
    done += batch.size();
  } while (done < ids.size());
}

void addMaybe(FieldDigest& digest, const std::optional<std::int64_t>& number) {
  digest.add(number ? 1 : 0).add(number.value_or(0));
}

}  // namespace

std::string textHash(const std::string& text) {
  return text.empty() ? std::string() : FieldDigest("torsio text 1").add(text).hex();
}

std::map<std::string, std::string> markHashes(Connection& connection, std::span<const std::string> ids) {
  std::map<std::string, FieldDigest> digests;
  const std::string marks =
      "SELECT id, enrolment_id, rater_id, scoring_point, version, trial_id, score_steps, scale_lo_steps,"
      " scale_hi_steps, steps_per_point, not_assessable_reason, comment_hash, amend_reason, submitted_utc_us,"
      " demonstration, assignment_id FROM training_mark";
  forEachRow(connection, marks, "id", ids, "id", [&](const Statement& mark) {
    FieldDigest digest("torsio training mark 1");
    for (int column = 0; column <= 3; ++column) digest.add(mark.text(column));
    digest.add(mark.int64(4)).add(mark.text(5));
    addMaybe(digest, mark.maybeInt64(6));
    for (int column = 7; column <= 9; ++column) digest.add(mark.int64(column));
    for (int column = 10; column <= 12; ++column) digest.add(mark.text(column));
    digest.add(mark.int64(13)).add(mark.boolean(14)).add(mark.text(15));
    digests.emplace(mark.text(0), digest);
  });
  const std::string rows =
      "SELECT mark_id, revision_id, row_code, score_steps, not_assessable_reason FROM training_mark_row";
  forEachRow(connection, rows, "mark_id", ids, "mark_id, row_code", [&](const Statement& row) {
    const auto found = digests.find(row.text(0));
    if (found == digests.end()) return;
    found->second.add(row.text(1)).add(row.text(2));
    addMaybe(found->second, row.maybeInt64(3));
    found->second.add(row.text(4));
  });
  std::map<std::string, std::string> hashes;
  for (const auto& [id, digest] : digests) hashes[id] = digest.hex();
  return hashes;
}

std::map<std::string, std::string> evaluationMarkHashes(Connection& connection,
                                                        std::span<const std::string> ids) {
  std::map<std::string, std::string> hashes;
  const std::string marks =
      "SELECT id, campaign_id, rater_id, model_code, index_number, version, score_steps, amend_reason,"
      " submitted_utc_us, demonstration FROM evaluation_mark";
  forEachRow(connection, marks, "id", ids, "id", [&](const Statement& mark) {
    FieldDigest digest("torsio evaluation mark 1");
    for (int column = 0; column <= 3; ++column) digest.add(mark.text(column));
    for (int column = 4; column <= 6; ++column) digest.add(mark.int64(column));
    digest.add(mark.text(7)).add(mark.int64(8)).add(mark.boolean(9));
    hashes[mark.text(0)] = digest.hex();
  });
  return hashes;
}

std::map<std::string, std::string> trialHashes(Connection& connection, std::span<const std::string> ids) {
  std::map<std::string, std::string> hashes;
  const std::string trials =
      "SELECT trial_id, sample_count, refused_samples, late_ticks, outcome, content_hash, ended_utc_us"
      " FROM trial_end";
  forEachRow(connection, trials, "trial_id", ids, "trial_id", [&](const Statement& trial) {
    FieldDigest digest("torsio trial end 1");
    digest.add(trial.text(0)).add(trial.int64(1)).add(trial.int64(2)).add(trial.int64(3));
    digest.add(trial.text(4)).add(trial.text(5)).add(trial.int64(6));
    hashes[trial.text(0)] = digest.hex();
  });
  return hashes;
}

}  // namespace torsio
