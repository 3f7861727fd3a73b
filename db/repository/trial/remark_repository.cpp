// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/remark_repository.h"

#include <algorithm>

#include "assessment/domain/ids.h"
#include "db/repository/base/learning_events.h"
#include "db/repository/base/row_columns.h"

namespace torsio {

namespace {

constexpr auto kRemark = rowColumns<Remark>(
    "trial_remark",
    "id, trial_id, author, author_person_id, purpose, reply_to, tick, time_us, text, created_utc_us,"
    " demonstration",
    &Remark::id, &Remark::trialId, &Remark::author, OrNull{&Remark::authorPersonId}, &Remark::purpose,
    OrNull{&Remark::replyTo}, &Remark::tick, &Remark::time_us, OrNull{&Remark::text}, &Remark::createdUtc_us,
    &Remark::demonstration);

constexpr auto kRevision = rowColumns<RemarkRevision>(
    "remark_revision", "remark_id, version, author, author_person_id, text, created_utc_us",
    &RemarkRevision::remarkId, &RemarkRevision::version, &RemarkRevision::author,
    OrNull{&RemarkRevision::authorPersonId}, &RemarkRevision::text, &RemarkRevision::createdUtc_us);

constexpr auto kSelfScore = rowColumns<SelfScore>(
    "self_score",
    "id, trial_id, trainee_id, version, rubric_revision_id, score_steps, scale_lo_steps, scale_hi_steps,"
    " steps_per_point, created_utc_us, demonstration",
    &SelfScore::id, &SelfScore::trialId, &SelfScore::traineeId, &SelfScore::version,
    OrNull{&SelfScore::rubricRevisionId}, &SelfScore::score_steps, &SelfScore::scale,
    &SelfScore::createdUtc_us, &SelfScore::demonstration);

using Calibration = CalibrationScore;
constexpr auto kCalibration = rowColumns<Calibration>(
    "rater_warmup",
    "id, rater_id, reference_trial_id, rubric_revision_id, score_steps, scale_lo_steps, scale_hi_steps,"
    " steps_per_point, panel_offset_steps, created_utc_us, demonstration",
    &Calibration::id, &Calibration::raterId, &Calibration::referenceTrialId,
    OrNull{&Calibration::rubricRevisionId}, &Calibration::score_steps, &Calibration::scale,
    &Calibration::panelOffset_steps, &Calibration::createdUtc_us, &Calibration::demonstration);

const std::string kRemarks =
    "SELECT m.id, m.trial_id, m.author, m.author_person_id, m.purpose, m.reply_to, m.tick, m.time_us, " +
    newestOfRemark("m", "text", "m.text") + ", m.created_utc_us, m.demonstration, " +
    newestOfRemark("m", "version", "1") + ", " + newestOfRemark("m", "created_utc_us", "0") +
    " FROM trial_remark m";
const std::string kNotReadBy =
    " AND m.author <> ? AND NOT EXISTS (SELECT 1 FROM remark_receipt c WHERE c.remark_id = m.id"
    " AND c.reader = ? AND c.version = " +
    newestOfRemark("m", "version", "1") + ") ORDER BY m.created_utc_us, m.id";

Remark remarkOf(RowReader& row) {
  return {.id = row.text(),
          .trialId = row.text(),
          .author = row.text(),
          .authorPersonId = row.text(),
          .purpose = row.text(),
          .replyTo = row.text(),
          .tick = row.int64(),
          .time_us = row.int64(),
          .text = row.text(),
          .createdUtc_us = row.int64(),
          .demonstration = row.boolean(),
          .version = row.int64(),
          .editedUtc_us = row.int64()};
}

std::vector<SelfScoreLine> selfScoreRows(Connection& connection, const SelfScoreId& selfScoreId) {
  return selectAll(connection,
                   "SELECT revision_id, row_code, score_steps FROM self_score_row WHERE self_score_id = ?"
                   " ORDER BY row_code",
                   {selfScoreId}, [](RowReader& row) {
                     return SelfScoreLine{row.text(), row.text(), row.int64()};
                   });
}

}  // namespace

void RemarkRepository::add(const Remark& remark) {
  Transaction transaction(connection_);
  kRemark.insertOnce(connection_, remark, "id", "created_utc_us", Text::tr("this remark"));
  transaction.commit();
}

std::optional<Remark> RemarkRepository::find(const RemarkId& remarkId) const {
  return selectFirst(connection_, kRemarks + " WHERE m.id = ?", {remarkId}, remarkOf);
}

std::vector<Remark> RemarkRepository::remarks(const TrialId& trialId) const {
  return selectAll(connection_, kRemarks + " WHERE m.trial_id = ? ORDER BY m.time_us, m.created_utc_us, m.id",
                   {trialId}, remarkOf);
}

void RemarkRepository::revise(const RemarkRevision& revision) {
  Transaction transaction(connection_);
  kRevision.insertOnce(connection_, revision, "remark_id, version", "created_utc_us",
                       Text::tr("this version of the remark"));
  transaction.commit();
}

std::map<RemarkId, std::vector<RemarkWording>> RemarkRepository::earlierWordings(
    const TrialId& trialId) const {
  Statement rows = connection_.prepare(
      "SELECT m.id, 1 AS version, m.text, m.created_utc_us FROM trial_remark m WHERE m.trial_id = ?"
      " AND EXISTS (SELECT 1 FROM remark_revision n WHERE n.remark_id = m.id)"
      " UNION ALL SELECT v.remark_id, v.version, v.text, v.created_utc_us FROM trial_remark o"
      " JOIN remark_revision v ON v.remark_id = o.id WHERE o.trial_id = ?"
      " AND EXISTS (SELECT 1 FROM remark_revision n WHERE n.remark_id = v.remark_id"
      " AND n.version > v.version) ORDER BY 1, 2");
  rows.execute({trialId, trialId});
  std::map<RemarkId, std::vector<RemarkWording>> earlier;
  while (rows.step()) {
    RowReader row(rows);
    const RemarkId remarkId = row.text();
    row.skip(1);
    const std::string text = row.text();
    earlier[remarkId].push_back({text, row.int64()});
  }
  return earlier;
}

void RemarkRepository::markRead(const ReadReceipt& receipt) {
  Transaction transaction(connection_);
  connection_.execute(
      insertInto("remark_receipt", "remark_id, reader, version, reader_person_id, read_utc_us") +
          " ON CONFLICT (remark_id, reader, version) DO NOTHING",
      {receipt.remarkId, receipt.reader, receipt.version, textOrNull(receipt.readerPersonId),
       receipt.readUtc_us});
  noteLearningEvents(connection_, LearningEventKind::kRemarkRead, {&receipt.remarkId.text(), 1});
  transaction.commit();
}

std::vector<ReadReceipt> RemarkRepository::receipts(const TrialId& trialId) const {
  return selectAll(
      connection_,
      "SELECT c.remark_id, c.version, c.reader, c.reader_person_id, c.read_utc_us FROM trial_remark m"
      " JOIN remark_receipt c ON c.remark_id = m.id WHERE m.trial_id = ? ORDER BY c.read_utc_us, c.remark_id,"
      " c.reader",
      {trialId}, [](RowReader& row) {
        return ReadReceipt{row.text(), row.int64(), row.text(), row.text(), row.int64()};
      });
}

std::vector<Remark> RemarkRepository::unreadOnTrialsOf(const TraineeId& traineeId,
                                                       const std::string& reader) const {
  return selectAll(
      connection_,
      kRemarks + " JOIN trial t ON t.id = m.trial_id WHERE t.trainee_id = ? AND m.purpose <> 'bookmark'" +
          kNotReadBy,
      {traineeId, reader, reader}, remarkOf);
}

std::vector<Remark> RemarkRepository::unreadReplies(const std::string& author) const {
  return selectAll(connection_,
                   kRemarks + " JOIN trial_remark o ON o.id = m.reply_to WHERE o.author = ?" + kNotReadBy,
                   {author, author, author}, remarkOf);
}

void RemarkRepository::addSelfScore(const SelfScore& score) {
  Transaction transaction(connection_);
  if (kSelfScore.insertOnce(connection_, score, "id", "created_utc_us", Text::tr("this self-score")) ==
      Inserted::kNew) {
    Statement insert = connection_.prepare(
        insertInto("self_score_row", "self_score_id, revision_id, row_code, score_steps"));
    for (const SelfScoreLine& row : score.rows) {
      insert.execute({score.id, row.rubricRevisionId, row.rowCode, row.score_steps});
    }
  } else if (const std::vector<SelfScoreLine> stored = selfScoreRows(connection_, score.id);
             !std::is_permutation(stored.begin(), stored.end(), score.rows.begin(), score.rows.end())) {
    refuseOtherContent(connection_, "self_score_row", Text::tr("this self-score"));
  }
  transaction.commit();
}

std::vector<SelfScore> RemarkRepository::selfScores(const TrialId& trialId) const {
  std::vector<SelfScore> scores = selectAll(
      connection_,
      kSelfScore.select("s") + " FROM self_score s WHERE s.trial_id = ? ORDER BY s.trainee_id, s.version",
      {trialId}, kSelfScore);
  for (SelfScore& score : scores) {
    score.rows = selfScoreRows(connection_, score.id);
  }
  return scores;
}

void RemarkRepository::addCalibrationScore(const CalibrationScore& score) {
  Transaction transaction(connection_);
  kCalibration.insertOnce(connection_, score, "id", "created_utc_us", Text::tr("this rater calibration"));
  transaction.commit();
}

std::vector<CalibrationScore> RemarkRepository::calibrationScores(const RaterId& raterId) const {
  return selectAll(
      connection_,
      kCalibration.select("s") + " FROM rater_warmup s WHERE s.rater_id = ? ORDER BY s.created_utc_us, s.id",
      {raterId}, kCalibration);
}

namespace {

const std::string kQuestions =
    "SELECT q.remark_id, q.rater_id, q.asked_utc_us, m.trial_id, m.author_person_id, m.time_us, " +
    newestOfRemark("m", "text", "m.text") +
    " FROM trial_question q JOIN trial_remark m ON m.id = q.remark_id WHERE ";

bool waits(const TraineeQuestion& question) {
  return question.answerId.empty();
}

}  // namespace

void QuestionRepository::add(const TraineeQuestion& question) {
  connection_.execute(insertInto("trial_question", "remark_id, rater_id, asked_utc_us"),
                      {question.remarkId, question.raterId, question.askedUtc_us});
}

std::vector<TraineeQuestion> QuestionRepository::read(const std::string& condition,
                                                      const std::string& value) const {
  std::vector<TraineeQuestion> questions =
      selectAll(connection_, kQuestions + condition, {value}, [](RowReader& row) {
        return TraineeQuestion{.remarkId = row.text(),
                               .raterId = row.text(),
                               .askedUtc_us = row.int64(),
                               .trialId = row.text(),
                               .personId = row.text(),
                               .time_us = row.int64(),
                               .text = row.text()};
      });
  Statement answer =
      connection_.prepare("SELECT a.id, " + newestOfRemark("a", "text", "a.text") + ", a.created_utc_us, " +
                          newestOfRemark("a", "created_utc_us", "0") +
                          " FROM trial_remark a WHERE a.reply_to = ? AND a.author_person_id = ?"
                          " ORDER BY a.created_utc_us, a.id LIMIT 1");
  for (TraineeQuestion& question : questions) {
    answer.execute({question.remarkId, question.raterId});
    while (answer.step()) {
      RowReader row(answer);
      question.answerId = row.text();
      question.answerText = row.text();
      question.answeredUtc_us = row.int64();
      question.answerEditedUtc_us = row.int64();
    }
  }
  return questions;
}

std::optional<TraineeQuestion> QuestionRepository::find(const RemarkId& remarkId) const {
  std::vector<TraineeQuestion> found = read("q.remark_id = ?", remarkId);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::vector<TraineeQuestion> QuestionRepository::ofTrial(const TrialId& trialId) const {
  return read("m.trial_id = ? ORDER BY m.time_us, q.asked_utc_us, q.remark_id", trialId);
}

std::vector<TraineeQuestion> QuestionRepository::toRater(const RaterId& raterId) const {
  std::vector<TraineeQuestion> questions =
      read("q.rater_id = ? ORDER BY q.asked_utc_us, q.remark_id", raterId);
  const auto answered = std::stable_partition(questions.begin(), questions.end(), waits);
  std::reverse(answered, questions.end());
  return questions;
}

std::string QuestionRepository::lastAsked(const PersonId& personId) const {
  return selectFirst(connection_,
                     "SELECT q.rater_id FROM trial_question q JOIN trial_remark m ON m.id = q.remark_id"
                     " WHERE m.author_person_id = ? ORDER BY q.asked_utc_us DESC, q.remark_id LIMIT 1",
                     {personId}, readText)
      .value_or("");
}

bool QuestionRepository::isScored(const TrialId& trialId) const {
  return selectFirst(connection_,
                     "SELECT EXISTS (SELECT 1 FROM assignment WHERE trial_id = ?)"
                     " OR EXISTS (SELECT 1 FROM training_mark WHERE trial_id = ?)"
                     " OR EXISTS (SELECT 1 FROM reference_run WHERE trial_id = ?)",
                     {trialId, trialId, trialId}, readBoolean)
      .value_or(false);
}

}  // namespace torsio
