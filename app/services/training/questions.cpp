// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/questions.h"

#include <algorithm>
#include <map>
#include <utility>

#include "app/services/recording/kept_digests.h"
#include "app/services/study/remark_revision.h"
#include "app/services/training/trainee_record.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/remark.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

constexpr const char* kChief = "chief";

std::string nameOf(PeopleRepository& people, const PersonId& personId, const std::string& code) {
  const std::optional<Identity> identity = people.identity(personId);
  return identity && !identity->fullName.empty() ? identity->fullName : code;
}

double secondsOf(std::int64_t time_us) {
  return static_cast<double>(time_us) * 1e-6;
}

AskedQuestion asked(const TraineeQuestion& stored) {
  return {.id = stored.remarkId,
          .at_s = secondsOf(stored.time_us),
          .text = stored.text,
          .askedUtc_us = stored.askedUtc_us,
          .answered = !stored.answerId.empty(),
          .answer = stored.answerText,
          .answeredUtc_us = stored.answeredUtc_us,
          .answerEditedUtc_us = stored.answerEditedUtc_us};
}

/// Only for practice that was never given to raters.
bool namesMayBeShown(SessionContext& session, const TrialListing& trial) {
  return trial.attemptMode == AttemptMode::kPractice &&
         !QuestionRepository(session.connection()).isScored(trial.trialId);
}

/// Returns chief physicians who can sign in; simulated ones only for simulated trainees, and vice versa.
std::vector<AskablePhysician> askable(SessionContext& session, const TraineeRecord& record) {
  PeopleRepository people(session.connection());
  const std::string last = QuestionRepository(session.connection()).lastAsked(record.personId);
  std::vector<AskablePhysician> physicians;
  for (const Rater& rater : people.raters()) {
    const Person& person = rater.person;
    if (rater.classCode != kChief || person.state != PersonState::kActive) {
      continue;
    }
    if (person.demonstration != record.demonstration) {
      continue;
    }
    physicians.push_back({person.id, nameOf(people, person.id, person.code), person.id == last});
  }
  return physicians;
}

TraineeQuestion questionToMe(SessionContext& session, const RemarkId& questionId) {
  session.require(Operation::kTrialViewAssigned);
  const std::optional<TraineeQuestion> question = QuestionRepository(session.connection()).find(questionId);
  if (!question) {
    refuseParameter(Text::tr("there is no such question"), questionId, Text::tr("Open the list again"));
  }
  if (session.actor().personId.empty() || question->raterId != session.actor().personId) {
    throw Error(ErrorCode::kPermission, Text::tr("this question was put to somebody else"), questionId,
                Text::tr("Open one of your own"));
  }
  return *question;
}

std::string moduleTitle(SessionContext& session, const TrialId& trialId) {
  const auto context = TrialRepository(session.connection()).context(trialId);
  if (!context || context->moduleId.empty()) {
    return {};
  }
  Statement row = session.connection().prepare("SELECT title FROM module WHERE id = ?");
  row.execute({context->moduleId});
  std::string title;
  while (row.step()) {
    title = row.text(0);
  }
  return title;
}

}  // namespace

QuestionDesk questionDesk(SessionContext& session, const TrialId& trialId) {
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  const TrialListing trial = ownTrial(session, record, trialId);
  PeopleRepository people(session.connection());
  QuestionDesk desk;
  desk.physicians = askable(session, record);
  desk.mayAsk = namesMayBeShown(session, trial) && !desk.physicians.empty();
  for (const TraineeQuestion& stored : QuestionRepository(session.connection()).ofTrial(trialId)) {
    const std::optional<Person> person = people.find(stored.raterId);
    desk.questions.push_back({asked(stored), nameOf(people, stored.raterId, person ? person->code : "")});
  }
  return desk;
}

RemarkId askPhysician(SessionContext& session, const TrialId& trialId, double at_s, const RaterId& raterId,
                      const std::string& text) {
  const TraineeRecord record = ownRecord(session, Operation::kTrialViewOwn);
  const TrialListing trial = ownTrial(session, record, trialId);
  if (!namesMayBeShown(session, trial)) {
    throw Error(ErrorCode::kPermission, Text::tr("this run is or may be judged without names"), trialId,
                Text::tr("Ask about a practice run"));
  }
  if (text.find_first_not_of(" \t\n") == std::string::npos) {
    refuseParameter(Text::tr("a question needs words"), trialId, Text::tr("Write what you want to know"));
  }
  const std::vector<AskablePhysician> physicians = askable(session, record);
  if (std::none_of(physicians.begin(), physicians.end(),
                   [&](const AskablePhysician& one) { return one.raterId == raterId; })) {
    refuseParameter(Text::tr("this physician cannot be asked"), raterId,
                    Text::tr("Choose one from the list"));
  }
  Transaction transaction(session.connection());
  const RemarkId id = keepBookmark(session, trial, at_s, text);
  QuestionRepository(session.connection())
      .add({.remarkId = id, .raterId = raterId, .askedUtc_us = session.now_us()});
  session.note(AuditAction::kQuestionAsk, AuditObject::kTrialQuestion, id);
  transaction.commit();
  return id;
}

std::vector<PhysicianQuestion> questionsToMe(SessionContext& session) {
  session.require(Operation::kTrialViewAssigned);
  std::vector<PhysicianQuestion> questions;
  if (session.actor().personId.empty()) {
    return questions;
  }
  PeopleRepository people(session.connection());
  for (const TraineeQuestion& stored :
       QuestionRepository(session.connection()).toRater(session.actor().personId)) {
    const std::optional<Person> person = people.find(stored.personId);
    std::map<RemarkId, std::vector<RemarkWording>> earlier;
    if (stored.answerEditedUtc_us != 0) {
      earlier = RemarkRepository(session.connection()).earlierWordings(stored.trialId);
    }
    questions.push_back({asked(stored), nameOf(people, stored.personId, person ? person->code : ""),
                         moduleTitle(session, stored.trialId), stored.trialId,
                         std::move(earlier[stored.answerId])});
  }
  return questions;
}

Debrief questionedRun(SessionContext& session, const RemarkId& questionId) {
  const TraineeQuestion question = questionToMe(session, questionId);
  const Trial trial = TrialRepository(session.connection()).load(question.trialId);
  const std::optional<TrialContext> context = TrialRepository(session.connection()).context(question.trialId);
  ExerciseRules exercises;
  const AttemptRules rules =
      recordedRules(exercises.of(session.connection(), trial.header.sceneId, trial.header.patternId,
                                 context ? context->moduleId : ModuleId()),
                    trial.header);
  Debrief run = makeDebrief(trial.header, decodeTrial(trial), rules, nullptr);
  run.moduleTitle = moduleTitle(session, question.trialId);
  run.bookmarks.push_back({question.remarkId, secondsOf(question.time_us), question.text});
  return run;
}

void answerQuestion(SessionContext& session, const RemarkId& questionId, const std::string& text) {
  const TraineeQuestion question = questionToMe(session, questionId);
  if (text.empty()) {
    refuseParameter(Text::tr("the answer is empty"), "", Text::tr("Write what you want to say"));
  }
  RemarkRepository remarks(session.connection());
  const std::optional<Remark> bookmark = remarks.find(questionId);
  const RemarkId id = session.ids().newUuid();
  Transaction transaction(session.connection());
  remarks.add({.id = id,
               .trialId = question.trialId,
               .author = session.actor().userId,
               .authorPersonId = session.actor().personId,
               .purpose = "reply",
               .replyTo = questionId,
               .tick = bookmark ? bookmark->tick : 0,
               .time_us = question.time_us,
               .text = text,
               .createdUtc_us = session.now_us(),
               .demonstration = bookmark && bookmark->demonstration});
  session.note(AuditAction::kQuestionAnswer, AuditObject::kTrialQuestion, questionId);
  transaction.commit();
}

void editAnswer(SessionContext& session, const RemarkId& questionId, const std::string& text) {
  const TraineeQuestion question = questionToMe(session, questionId);
  RemarkRepository remarks(session.connection());
  const std::optional<Remark> answer = remarks.find(question.answerId);
  if (!answer) {
    refuseParameter(Text::tr("this question has no answer yet"), questionId, Text::tr("Answer it first"));
  }
  reviseRemark(session, *answer, text);
}

}  // namespace torsio
