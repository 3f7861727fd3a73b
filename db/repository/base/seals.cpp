// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/seals.h"

#include <algorithm>
#include <vector>

#include "db/connection/row_reader.h"
#include "db/repository/base/field_digest.h"

namespace torsio {

namespace {

constexpr std::size_t kBatch = 500;  // placeholders per statement; SQLite allows 32766

/// Calls `read` for every row of `sql` whose `column` is among `ids`, or for all rows if `ids` is empty.
template <typename Kind, typename Read>
void forEachRow(Connection& connection, const std::string& sql, const std::string& column,
                std::span<const Kind> ids, const std::string& order, Read&& read) {
  std::size_t done = 0;
  do {
    const std::span<const Kind> batch = ids.subspan(done, std::min(kBatch, ids.size() - done));
    std::string where;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      where += i == 0 ? "?" : ", ?";
    }
    if (!where.empty()) {
      where = " WHERE " + column + " IN (" + where + ")";
    }
    Statement row = connection.prepare(sql + where + " ORDER BY " + order);
    row.execute(std::vector<Value>(batch.begin(), batch.end()));
    while (row.step()) {
      RowReader reader(row);
      read(reader);
    }
    done += batch.size();
  } while (done < ids.size());
}

void addMaybe(FieldDigest& digest, const std::optional<std::int64_t>& number) {
  digest.add(number ? 1 : 0).add(number.value_or(0));
}

/// Adds the three columns of a scale: its ends and its steps per point.
void addScale(FieldDigest& digest, RowReader& row) {
  for (int part = 0; part < 3; ++part) {
    digest.add(row.int64());
  }
}

}  // namespace

std::map<std::string, std::string> markHashes(Connection& connection, std::span<const MarkId> ids) {
  std::map<std::string, FieldDigest> digests;
  const std::string marks =
      "SELECT id, enrolment_id, rater_id, occasion, version, trial_id, score_steps, scale_lo_steps,"
      " scale_hi_steps, steps_per_point, not_assessable_reason, amend_reason, submitted_utc_us,"
      " demonstration, assignment_id FROM training_mark";
  forEachRow(connection, marks, "id", ids, "id", [&](RowReader& mark) {
    FieldDigest digest("torsio training mark 2");
    const std::string id = mark.text();
    digest.add(id).add(mark.text());  // enrolment
    digest.add(mark.text());          // rater
    digest.add(mark.text());          // occasion
    digest.add(mark.int64());         // version
    digest.add(mark.text());          // trial
    addMaybe(digest, mark.maybeInt64());
    addScale(digest, mark);
    digest.add(mark.text());  // reason: not assessable
    digest.add(mark.text());  // reason of the amendment
    digest.add(mark.int64());
    digest.add(mark.boolean());
    digest.add(mark.text());  // assignment
    digests.emplace(id, digest);
  });
  const std::string rows =
      "SELECT mark_id, revision_id, row_code, score_steps, not_assessable_reason FROM training_mark_row";
  forEachRow(connection, rows, "mark_id", ids, "mark_id, row_code", [&](RowReader& row) {
    const auto found = digests.find(row.text());
    if (found == digests.end()) {
      return;
    }
    found->second.add(row.text());  // revision of the rubric
    found->second.add(row.text());  // row of the rubric
    addMaybe(found->second, row.maybeInt64());
    found->second.add(row.text());  // reason: not assessable
  });
  std::map<std::string, std::string> hashes;
  for (const auto& [id, digest] : digests) {
    hashes[id] = digest.hex();
  }
  return hashes;
}

std::map<std::string, std::string> evaluationMarkHashes(Connection& connection,
                                                        std::span<const EvaluationMarkId> ids) {
  std::map<std::string, std::string> hashes;
  const std::string marks =
      "SELECT id, campaign_id, rater_id, model_code, index_number, version, score_steps, amend_reason,"
      " submitted_utc_us, demonstration FROM evaluation_mark";
  forEachRow(connection, marks, "id", ids, "id", [&](RowReader& mark) {
    FieldDigest digest("torsio evaluation mark 1");
    const std::string id = mark.text();
    digest.add(id).add(mark.text());  // campaign
    digest.add(mark.text());          // rater
    digest.add(mark.text());          // model
    digest.add(mark.int64());         // index
    digest.add(mark.int64());         // version
    digest.add(mark.int64());         // score
    digest.add(mark.text());          // reason of the amendment
    digest.add(mark.int64());
    digest.add(mark.boolean());
    hashes[id] = digest.hex();
  });
  return hashes;
}

std::map<std::string, std::string> trialHashes(Connection& connection, std::span<const TrialId> ids) {
  std::map<std::string, std::string> hashes;
  const std::string trials =
      "SELECT trial_id, sample_count, refused_samples, late_ticks, outcome, content_hash, ended_utc_us,"
      " skipped_ticks, force_cuts, real_time_priority, memory_locked FROM trial_end";
  forEachRow(connection, trials, "trial_id", ids, "trial_id", [&](RowReader& trial) {
    FieldDigest digest("torsio trial end 1");
    const std::string id = trial.text();
    digest.add(id).add(trial.int64());  // samples
    digest.add(trial.int64());          // refused samples
    digest.add(trial.int64());          // late ticks
    digest.add(trial.text());           // outcome
    digest.add(trial.text());           // content hash
    digest.add(trial.int64());
    if (trial.nextIsNull()) {
      trial.skip(4);  // not in real time
    } else {
      digest.add(trial.int64()).add(trial.int64());      // skipped ticks, cuts of the force
      digest.add(trial.boolean()).add(trial.boolean());  // priority, memory
    }
    hashes[id] = digest.hex();
  });
  return hashes;
}

}  // namespace torsio
