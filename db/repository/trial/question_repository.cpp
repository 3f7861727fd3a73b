// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/question_repository.h"

#include <algorithm>

#include "assessment/domain/ids.h"
#include "db/connection/row_reader.h"
#include "db/repository/trial/remark_repository.h"

namespace torsio {

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
