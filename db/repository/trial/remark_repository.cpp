// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/remark_repository.h"

#include <algorithm>
#include <array>

#include "db/repository/base/insert_idempotent.h"

namespace torsio {

namespace {

using Kind = IdempotentColumn::Kind;

const std::string kRemarks =
    "SELECT m.id, m.trial_id, m.author, m.author_person_id, m.purpose, m.reply_to, m.tick, m.time_us, m.text,"
    " m.created_utc_us, m.demonstration FROM trial_remark m";
const std::string kNotReadBy =
    " AND m.author <> ? AND NOT EXISTS (SELECT 1 FROM remark_receipt c WHERE c.remark_id = m.id"
    " AND c.reader = ?) ORDER BY m.created_utc_us, m.id";

std::vector<StoredRemark> remarksOf(Statement& row) {
  std::vector<StoredRemark> remarks;
  while (row.step()) {
    remarks.push_back({.id = row.text(0),
                       .trialId = row.text(1),
                       .author = row.text(2),
                       .authorPersonId = row.text(3),
                       .purpose = row.text(4),
                       .replyTo = row.text(5),
                       .tick = row.int64(6),
                       .time_us = row.int64(7),
                       .text = row.text(8),
                       .createdUtc_us = row.int64(9),
                       .demonstration = row.boolean(10)});
  }
  return remarks;
}

std::vector<StoredSelfScoreRow> selfScoreRows(Connection& connection, const std::string& selfScoreId) {
  std::vector<StoredSelfScoreRow> rows;
  Statement row = connection.prepare(
      "SELECT revision_id, row_code, score_steps FROM self_score_row WHERE self_score_id = ?"
      " ORDER BY row_code");
  row.execute({selfScoreId});
  while (row.step()) rows.push_back({row.text(0), row.text(1), row.int64(2)});
  return rows;
}

}  // namespace

void RemarkRepository::add(const StoredRemark& remark) {
  Transaction transaction(connection_);
  const std::array<IdempotentColumn, 11> columns{{{"id", remark.id, Kind::kKey},
                                                  {"trial_id", remark.trialId},
                                                  {"author", remark.author},
                                                  {"author_person_id", textOrNull(remark.authorPersonId)},
                                                  {"purpose", remark.purpose},
                                                  {"reply_to", textOrNull(remark.replyTo)},
                                                  {"tick", remark.tick},
                                                  {"time_us", remark.time_us},
                                                  {"text", textOrNull(remark.text)},
                                                  {"created_utc_us", remark.createdUtc_us, Kind::kIgnored},
                                                  {"demonstration", remark.demonstration}}};
  insertIdempotent(connection_, "trial_remark", columns, "this remark");
  transaction.commit();
}

std::optional<StoredRemark> RemarkRepository::find(const std::string& remarkId) {
  Statement row = connection_.prepare(kRemarks + " WHERE m.id = ?");
  row.execute({remarkId});
  std::vector<StoredRemark> found = remarksOf(row);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::vector<StoredRemark> RemarkRepository::remarks(const std::string& trialId) {
  Statement row =
      connection_.prepare(kRemarks + " WHERE m.trial_id = ? ORDER BY m.time_us, m.created_utc_us, m.id");
  row.execute({trialId});
  return remarksOf(row);
}

void RemarkRepository::markRead(const StoredReceipt& receipt) {
  connection_.execute(
      "INSERT INTO remark_receipt (remark_id, reader, reader_person_id, read_utc_us) VALUES (?, ?, ?, ?)"
      " ON CONFLICT (remark_id, reader) DO NOTHING",
      {receipt.remarkId, receipt.reader, textOrNull(receipt.readerPersonId), receipt.readUtc_us});
}

std::vector<StoredReceipt> RemarkRepository::receipts(const std::string& trialId) {
  std::vector<StoredReceipt> receipts;
  Statement row = connection_.prepare(
      "SELECT c.remark_id, c.reader, c.reader_person_id, c.read_utc_us FROM trial_remark m"
      " JOIN remark_receipt c ON c.remark_id = m.id WHERE m.trial_id = ? ORDER BY c.read_utc_us, c.remark_id,"
      " c.reader");
  row.execute({trialId});
  while (row.step()) receipts.push_back({row.text(0), row.text(1), row.text(2), row.int64(3)});
  return receipts;
}

std::vector<StoredRemark> RemarkRepository::unreadOnTrialsOf(const std::string& traineeId,
                                                             const std::string& reader) {
  Statement row = connection_.prepare(
      kRemarks + " JOIN trial t ON t.id = m.trial_id WHERE t.trainee_id = ? AND m.purpose <> 'bookmark'" +
      kNotReadBy);
  row.execute({traineeId, reader, reader});
  return remarksOf(row);
}

std::vector<StoredRemark> RemarkRepository::unreadReplies(const std::string& author) {
  Statement row = connection_.prepare(
      kRemarks + " JOIN trial_remark o ON o.id = m.reply_to WHERE o.author = ?" + kNotReadBy);
  row.execute({author, author, author});
  return remarksOf(row);
}

void RemarkRepository::addSelfScore(const StoredSelfScore& score) {
  Transaction transaction(connection_);
  const std::array<IdempotentColumn, 11> columns{{{"id", score.id, Kind::kKey},
                                                  {"trial_id", score.trialId},
                                                  {"trainee_id", score.traineeId},
                                                  {"version", score.version},
                                                  {"rubric_revision_id", textOrNull(score.rubricRevisionId)},
                                                  {"score_steps", score.score_steps},
                                                  {"scale_lo_steps", score.scale.lo},
                                                  {"scale_hi_steps", score.scale.hi},
                                                  {"steps_per_point", score.scale.stepsPerPoint},
                                                  {"created_utc_us", score.createdUtc_us, Kind::kIgnored},
                                                  {"demonstration", score.demonstration}}};
  if (insertIdempotent(connection_, "self_score", columns, "this self-score") == Inserted::kNew) {
    Statement insert = connection_.prepare(
        "INSERT INTO self_score_row (self_score_id, revision_id, row_code, score_steps) VALUES (?, ?, ?, ?)");
    for (const StoredSelfScoreRow& row : score.rows) {
      insert.execute({score.id, row.rubricRevisionId, row.rowCode, row.score_steps});
    }
  } else if (const std::vector<StoredSelfScoreRow> stored = selfScoreRows(connection_, score.id);
             !std::is_permutation(stored.begin(), stored.end(), score.rows.begin(), score.rows.end())) {
    refuseOtherContent(connection_, "self_score_row", "this self-score");
  }
  transaction.commit();
}

std::vector<StoredSelfScore> RemarkRepository::selfScores(const std::string& trialId) {
  std::vector<StoredSelfScore> scores;
  Statement row = connection_.prepare(
      "SELECT id, trial_id, trainee_id, version, rubric_revision_id, score_steps, scale_lo_steps,"
      " scale_hi_steps, steps_per_point, created_utc_us, demonstration FROM self_score WHERE trial_id = ?"
      " ORDER BY trainee_id, version");
  row.execute({trialId});
  while (row.step()) {
    scores.push_back({.id = row.text(0),
                      .trialId = row.text(1),
                      .traineeId = row.text(2),
                      .version = row.int64(3),
                      .rubricRevisionId = row.text(4),
                      .score_steps = row.int64(5),
                      .scale = {row.int64(6), row.int64(7), row.int64(8)},
                      .rows = {},
                      .createdUtc_us = row.int64(9),
                      .demonstration = row.boolean(10)});
  }
  for (StoredSelfScore& score : scores) score.rows = selfScoreRows(connection_, score.id);
  return scores;
}

void RemarkRepository::addWarmup(const StoredWarmup& warmup) {
  Transaction transaction(connection_);
  const std::array<IdempotentColumn, 11> columns{{{"id", warmup.id, Kind::kKey},
                                                  {"rater_id", warmup.raterId},
                                                  {"reference_trial_id", warmup.referenceTrialId},
                                                  {"rubric_revision_id", textOrNull(warmup.rubricRevisionId)},
                                                  {"score_steps", warmup.score_steps},
                                                  {"scale_lo_steps", warmup.scale.lo},
                                                  {"scale_hi_steps", warmup.scale.hi},
                                                  {"steps_per_point", warmup.scale.stepsPerPoint},
                                                  {"panel_offset_steps", warmup.panelOffset_steps},
                                                  {"created_utc_us", warmup.createdUtc_us, Kind::kIgnored},
                                                  {"demonstration", warmup.demonstration}}};
  insertIdempotent(connection_, "rater_warmup", columns, "this warm-up");
  transaction.commit();
}

std::vector<StoredWarmup> RemarkRepository::warmups(const std::string& raterId) {
  std::vector<StoredWarmup> warmups;
  Statement row = connection_.prepare(
      "SELECT id, rater_id, reference_trial_id, rubric_revision_id, score_steps, scale_lo_steps,"
      " scale_hi_steps, steps_per_point, panel_offset_steps, created_utc_us, demonstration FROM rater_warmup"
      " WHERE rater_id = ? ORDER BY created_utc_us, id");
  row.execute({raterId});
  while (row.step()) {
    warmups.push_back({.id = row.text(0),
                       .raterId = row.text(1),
                       .referenceTrialId = row.text(2),
                       .rubricRevisionId = row.text(3),
                       .score_steps = row.int64(4),
                       .scale = {row.int64(5), row.int64(6), row.int64(7)},
                       .panelOffset_steps = row.real(8),
                       .createdUtc_us = row.int64(9),
                       .demonstration = row.boolean(10)});
  }
  return warmups;
}

}  // namespace torsio
