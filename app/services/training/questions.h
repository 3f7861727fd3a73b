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
  std::string name{};  ///< the code where no name is known
  bool lastAsked = false;
};

/// What a trainee asked about a moment of a run, and what came back.
struct OwnQuestion {
  RemarkId id{};
  std::string physician{};
  double at_s = 0.0;
  std::string text{};
  std::int64_t askedUtc_us = 0;
  bool answered = false;
  std::string answer{};
  std::int64_t answeredUtc_us = 0;
  std::int64_t answerEditedUtc_us = 0;  ///< 0: never edited
};

/// What may be asked about one own run.
struct QuestionDesk {
  /// Practice that raters were never given: both sides are known by name, and a graded run, or one that is or
  /// was a case, is judged without names. False too while there is nobody to ask.
  bool mayAsk = false;
  std::vector<AskablePhysician> physicians{};
  std::vector<OwnQuestion> questions{};  ///< by moment
};
/// kTrialViewOwn, own trials only.
[[nodiscard]] QuestionDesk questionDesk(SessionContext& session, const TrialId& trialId);

/// Sends a moment of a practice run to a chief physician; `text` may be empty: the moment speaks. It is a
/// bookmark, too. Returns its id. Audited. kTrialViewOwn, own trials only. Throws Error{kPermission} for a
/// trial that is, was or may become a blinded case, {kBadParameter} for a moment outside the recording or a
/// physician who cannot be asked.
RemarkId askPhysician(SessionContext& session, const TrialId& trialId, double at_s, const RaterId& raterId,
                      const std::string& text);

/// A question as the physician sees it.
struct PhysicianQuestion {
  RemarkId id{};
  std::string trainee{};  ///< name, or the code where no name is known
  std::string moduleTitle{};
  TrialId trialId{};
  double at_s = 0.0;
  std::string text{};
  std::int64_t askedUtc_us = 0;
  bool answered = false;
  std::string answer{};
  std::int64_t answeredUtc_us = 0;
  std::int64_t answerEditedUtc_us = 0;          ///< 0: never edited
  std::vector<RemarkWording> earlierAnswers{};  ///< what was answered before, oldest first
};
/// What this physician was asked: what waits first, oldest first. kTrialViewAssigned.
[[nodiscard]] std::vector<PhysicianQuestion> questionsToMe(SessionContext& session);
/// The run that one of these questions is about, without an expert's. kTrialViewAssigned; the question must
/// be to the actor.
[[nodiscard]] Debrief questionedRun(SessionContext& session, const RemarkId& questionId);
/// A remark at the moment of the question, for the trainee to read at once. Audited. kTrialViewAssigned; the
/// question must be to the actor. Throws Error{kBadParameter} for an empty text.
void answerQuestion(SessionContext& session, const RemarkId& questionId, const std::string& text);
/// New words for one's answer, beside the old ones. Audited. kTrialViewAssigned; the question must be to the
/// actor. Throws Error{kBadParameter} while it has no answer, and as revisionOf() does.
void editAnswer(SessionContext& session, const RemarkId& questionId, const std::string& text);

}  // namespace torsio
