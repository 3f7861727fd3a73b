// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/question_repository.h"

#include <algorithm>

namespace torsio {

namespace {

const std::string kQuestions =
    "SELECT q.remark_id, q.rater_id, q.asked_utc_us, m.trial_id, m.author_person_id, m.time_us, m.text"
    " FROM trial_question q JOIN trial_remark m ON m.id = q.remark_id WHERE ";

bool waits(const StoredQuestion& question) {
  return question.answerId.empty();
}

}  // namespace

void QuestionRepository::add(const StoredQuestion& question) {
  connection_.execute("INSERT INTO trial_question (remark_id, rater_id, asked_utc_us) VALUES (?, ?, ?)",
                      {question.remarkId, question.raterId, question.askedUtc_us});
}

std::vector<StoredQuestion> QuestionRepository::read(const std::string& condition, const std::string& value) {
  std::vector<StoredQuestion> questions;
  Statement row = connection_.prepare(kQuestions + condition);
  row.execute({value});
  while (row.step()) {
    questions.push_back({.remarkId = row.text(0),
                         .raterId = row.text(1),
                         .askedUtc_us = row.int64(2),
                         .trialId = row.text(3),
                         .personId = row.text(4),
                         .time_us = row.int64(5),
                         .text = row.text(6)});
  }
  Statement answer = connection_.prepare(
      "SELECT id, text, created_utc_us FROM trial_remark WHERE reply_to = ? AND author_person_id = ?"
      " ORDER BY created_utc_us, id LIMIT 1");
  for (StoredQuestion& question : questions) {
    answer.execute({question.remarkId, question.raterId});
    while (answer.step()) {
      question.answerId = answer.text(0);
      question.answerText = answer.text(1);
      question.answeredUtc_us = answer.int64(2);
    }
  }
  return questions;
}

std::optional<StoredQuestion> QuestionRepository::find(const std::string& remarkId) {
  std::vector<StoredQuestion> found = read("q.remark_id = ?", remarkId);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::vector<StoredQuestion> QuestionRepository::ofTrial(const std::string& trialId) {
  return read("m.trial_id = ? ORDER BY m.time_us, q.asked_utc_us, q.remark_id", trialId);
}

std::vector<StoredQuestion> QuestionRepository::toRater(const std::string& raterId) {
  std::vector<StoredQuestion> questions =
      read("q.rater_id = ? ORDER BY q.asked_utc_us, q.remark_id", raterId);
  const auto answered = std::stable_partition(questions.begin(), questions.end(), waits);
  std::reverse(answered, questions.end());
  return questions;
}

std::string QuestionRepository::lastAsked(const std::string& personId) {
  Statement row = connection_.prepare(
      "SELECT q.rater_id FROM trial_question q JOIN trial_remark m ON m.id = q.remark_id"
      " WHERE m.author_person_id = ? ORDER BY q.asked_utc_us DESC, q.remark_id LIMIT 1");
  row.execute({personId});
  std::string rater;
  while (row.step()) rater = row.text(0);
  return rater;
}

bool QuestionRepository::isScored(const std::string& trialId) {
  Statement row = connection_.prepare(
      "SELECT EXISTS (SELECT 1 FROM assignment WHERE trial_id = ?)"
      " OR EXISTS (SELECT 1 FROM training_mark WHERE trial_id = ?)"
      " OR EXISTS (SELECT 1 FROM reference_run WHERE trial_id = ?)");
  row.execute({trialId, trialId, trialId});
  bool scored = false;
  while (row.step()) scored = row.boolean(0);
  return scored;
}

}  // namespace torsio
