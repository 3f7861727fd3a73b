// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/training/questions.h"

#include <algorithm>
#include <utility>

#include "app/recording/kept_digests.h"
#include "app/training/bookmarks.h"
#include "app/training/trainee_record.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/trial/question_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "sim/base/error.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

constexpr const char* kChief = "chief";

std::string nameOf(PeopleRepository& people, const std::string& personId, const std::string& code) {
  const std::optional<StoredIdentity> identity = people.identity(personId);
  return identity && !identity->fullName.empty() ? identity->fullName : code;
}

double secondsOf(std::int64_t time_us) {
  return static_cast<double>(time_us) * 1e-6;
}

/// Practice, and never in the hands of raters.
bool namesMayBeShown(SessionContext& workplace, const TrialListing& trial) {
  return trial.attemptMode == AttemptMode::kPractice &&
         !QuestionRepository(workplace.connection()).isScored(trial.trialId);
}

/// Chiefs who can sign in; simulated ones for simulated trainees only, and the other way round.
std::vector<AskablePhysician> askable(SessionContext& workplace, const TraineeRecord& record) {
  PeopleRepository people(workplace.connection());
  const std::string last = QuestionRepository(workplace.connection()).lastAsked(record.personId);
  std::vector<AskablePhysician> physicians;
  for (const StoredRater& rater : people.raters()) {
    const StoredPerson& person = rater.person;
    if (rater.classCode != kChief || person.state != "active") {
      continue;
    }
    if (person.demonstration != record.demonstration) {
      continue;
    }
    physicians.push_back({person.id, nameOf(people, person.id, person.code), person.id == last});
  }
  return physicians;
}

StoredQuestion questionToMe(SessionContext& workplace, const std::string& questionId) {
  workplace.require(Operation::kTrialViewAssigned);
  const std::optional<StoredQuestion> question = QuestionRepository(workplace.connection()).find(questionId);
  if (!question) {
    throw Error(ErrorCode::kBadParameter, "there is no such question", questionId, "Open the list again");
  }
  if (workplace.actor().personId.empty() || question->raterId != workplace.actor().personId) {
    throw Error(ErrorCode::kPermission, "this question was put to somebody else", questionId,
                "Open one of your own");
  }
  return *question;
}

std::string moduleTitle(SessionContext& workplace, const std::string& trialId) {
  const auto context = TrialRepository(workplace.connection()).context(trialId);
  if (!context || context->moduleId.empty()) {
    return {};
  }
  Statement row = workplace.connection().prepare("SELECT title FROM module WHERE id = ?");
  row.execute({context->moduleId});
  std::string title;
  while (row.step()) {
    title = row.text(0);
  }
  return title;
}

}  // namespace

QuestionDesk questionDesk(SessionContext& workplace, const std::string& trialId) {
  const TraineeRecord record = ownRecord(workplace, Operation::kTrialViewOwn);
  const TrialListing trial = ownTrial(workplace, record, trialId);
  PeopleRepository people(workplace.connection());
  QuestionDesk desk;
  desk.physicians = askable(workplace, record);
  desk.mayAsk = namesMayBeShown(workplace, trial) && !desk.physicians.empty();
  for (const StoredQuestion& stored : QuestionRepository(workplace.connection()).ofTrial(trialId)) {
    const std::optional<StoredPerson> person = people.find(stored.raterId);
    desk.questions.push_back({.id = stored.remarkId,
                              .physician = nameOf(people, stored.raterId, person ? person->code : ""),
                              .at_s = secondsOf(stored.time_us),
                              .text = stored.text,
                              .askedUtc_us = stored.askedUtc_us,
                              .answered = !stored.answerId.empty(),
                              .answer = stored.answerText,
                              .answeredUtc_us = stored.answeredUtc_us});
  }
  return desk;
}

std::string askPhysician(SessionContext& workplace, const std::string& trialId, double at_s,
                         const std::string& raterId, const std::string& text) {
  const TraineeRecord record = ownRecord(workplace, Operation::kTrialViewOwn);
  const TrialListing trial = ownTrial(workplace, record, trialId);
  if (!namesMayBeShown(workplace, trial)) {
    throw Error(ErrorCode::kPermission, "this run is or may be judged without names", trialId,
                "Ask about a practice run");
  }
  const std::vector<AskablePhysician> physicians = askable(workplace, record);
  if (std::none_of(physicians.begin(), physicians.end(),
                   [&](const AskablePhysician& one) { return one.raterId == raterId; })) {
    throw Error(ErrorCode::kBadParameter, "this physician cannot be asked", raterId,
                "Choose one from the list");
  }
  Transaction transaction(workplace.connection());
  const std::string id = keepBookmark(workplace, trial, at_s, text);
  QuestionRepository(workplace.connection())
      .add({.remarkId = id, .raterId = raterId, .askedUtc_us = workplace.now_us()});
  workplace.note({.action = "question.ask", .objectKind = "trial_question", .objectId = id});
  transaction.commit();
  return id;
}

std::vector<PhysicianQuestion> questionsToMe(SessionContext& workplace) {
  workplace.require(Operation::kTrialViewAssigned);
  std::vector<PhysicianQuestion> questions;
  if (workplace.actor().personId.empty()) {
    return questions;
  }
  PeopleRepository people(workplace.connection());
  for (const StoredQuestion& stored :
       QuestionRepository(workplace.connection()).toRater(workplace.actor().personId)) {
    const std::optional<StoredPerson> person = people.find(stored.personId);
    questions.push_back({.id = stored.remarkId,
                         .trainee = nameOf(people, stored.personId, person ? person->code : ""),
                         .moduleTitle = moduleTitle(workplace, stored.trialId),
                         .trialId = stored.trialId,
                         .at_s = secondsOf(stored.time_us),
                         .text = stored.text,
                         .askedUtc_us = stored.askedUtc_us,
                         .answered = !stored.answerId.empty(),
                         .answer = stored.answerText});
  }
  return questions;
}

Debrief questionedRun(SessionContext& workplace, const std::string& questionId) {
  const StoredQuestion question = questionToMe(workplace, questionId);
  const Trial trial = TrialRepository(workplace.connection()).load(question.trialId);
  const std::optional<TrialContext> context =
      TrialRepository(workplace.connection()).context(question.trialId);
  ExerciseRules exercises;
  const AttemptRules rules =
      exercises.of(workplace.connection(), trial.header.sceneId, trial.header.patternId,
                   context ? context->moduleId : std::string());
  Debrief run = makeDebrief(trial.header, decodeTrial(trial), rules, nullptr);
  run.moduleTitle = moduleTitle(workplace, question.trialId);
  run.bookmarks.push_back({question.remarkId, secondsOf(question.time_us), question.text});
  return run;
}

void answerQuestion(SessionContext& workplace, const std::string& questionId, const std::string& text) {
  const StoredQuestion question = questionToMe(workplace, questionId);
  if (text.empty()) {
    throw Error(ErrorCode::kBadParameter, "the answer is empty", "", "Write what you want to say");
  }
  RemarkRepository remarks(workplace.connection());
  const std::optional<StoredRemark> bookmark = remarks.find(questionId);
  const std::string id = workplace.ids().newUuid();
  Transaction transaction(workplace.connection());
  remarks.add({.id = id,
               .trialId = question.trialId,
               .author = workplace.actor().userId,
               .authorPersonId = workplace.actor().personId,
               .purpose = "reply",
               .replyTo = questionId,
               .tick = bookmark ? bookmark->tick : 0,
               .time_us = question.time_us,
               .text = text,
               .createdUtc_us = workplace.now_us(),
               .demonstration = bookmark && bookmark->demonstration});
  workplace.note({.action = "question.answer", .objectKind = "trial_question", .objectId = questionId});
  transaction.commit();
}

}  // namespace torsio
