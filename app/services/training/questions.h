// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/training/debrief.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/remark.h"

namespace torsio {

/// A chief physician whom a trainee may ask.
struct AskablePhysician {
  RaterId raterId{};
  std::string name{};  ///< the code if no name is known
  bool lastAsked = false;
};

/// A question about a moment of a run, and its answer.
struct AskedQuestion {
  RemarkId id{};
  double at_s = 0.0;
  std::string text{};
  std::int64_t askedUtc_us = 0;
  bool answered = false;
  std::string answer{};
  std::int64_t answeredUtc_us = 0;
  std::int64_t answerEditedUtc_us = 0;  ///< 0: never edited
};

struct OwnQuestion : AskedQuestion {
  std::string physician{};
};

/// Questions about one of the trainee's runs.
struct QuestionDesk {
  /// Only for practice that raters were never given: both sides are known by name, while a graded run, or one
  /// that is or was a case, is judged anonymously. Also false if there is nobody to ask.
  bool mayAsk = false;
  std::vector<AskablePhysician> physicians{};
  std::vector<OwnQuestion> questions{};  ///< by time
};
/// kTrialViewOwn, the actor's trials.
[[nodiscard]] QuestionDesk questionDesk(SessionContext& session, const TrialId& trialId);

/// Asks a chief physician about a moment of a practice run; `text` may be empty. It is also a bookmark.
/// Returns its id. Audited. kTrialViewOwn, the actor's trials. Throws Error{kPermission} for a trial that is,
/// was or may become a blinded case, {kBadParameter} for a time outside the recording or a physician who
/// cannot be asked.
RemarkId askPhysician(SessionContext& session, const TrialId& trialId, double at_s, const RaterId& raterId,
                      const std::string& text);

/// A question as seen by the physician.
struct PhysicianQuestion : AskedQuestion {
  std::string trainee{};  ///< name, or the code if no name is known
  std::string moduleTitle{};
  TrialId trialId{};
  std::vector<RemarkWording> earlierAnswers{};  ///< previous versions, oldest first
};
/// Returns the questions to the actor: unanswered ones first, oldest first. kTrialViewAssigned.
[[nodiscard]] std::vector<PhysicianQuestion> questionsToMe(SessionContext& session);
/// Returns the run that a question is about, without an expert's. kTrialViewAssigned; the question must be to
/// the actor.
[[nodiscard]] Debrief questionedRun(SessionContext& session, const RemarkId& questionId);
/// Answers with a remark at the question's moment, which the trainee can read at once. Audited.
/// kTrialViewAssigned; the question must be to the actor. Throws Error{kBadParameter} for an empty text.
void answerQuestion(SessionContext& session, const RemarkId& questionId, const std::string& text);
/// Adds a version to the actor's answer. Audited. kTrialViewAssigned; the question must be to the actor.
/// Throws Error{kBadParameter} if there is no answer, and like revisionOf().
void editAnswer(SessionContext& session, const RemarkId& questionId, const std::string& text);

}  // namespace torsio
