// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/review/blinded_case.h"
#include "app/services/review/watch_log.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/rating/sheet_check.h"

namespace torsio {

/// The nine marks of one model (paper section 5.3), identified only by its hidden label.
struct EvaluationFormModel {
  std::string hiddenLabel{};                          ///< "X"
  std::vector<std::optional<std::int64_t>> scores{};  ///< steps, one per index; a draft until submitted
  bool submitted = false;
  bool recorded = false;  ///< has a recording (loadEvaluationRecording())
};

/// A rater's form, with the models in the rater's random order. Contains neither model names nor weights.
struct EvaluationForm {
  CampaignId campaignId{};  ///< argument of services; never shown
  std::string title{};
  ScoreScale scale{};
  std::vector<std::string> indices{};   ///< names, in instrument order
  std::vector<std::string> indexIds{};  ///< ids for indexMeaning
  std::vector<EvaluationFormModel> models{};
  [[nodiscard]] bool complete() const noexcept;
};

/// Returns the indices as rows of a rubric ("1" to "9") for use with the sheet editor; meanings become
/// anchors, definitions become descriptions.
[[nodiscard]] RubricRevision evaluationRubric(const EvaluationForm& form);
/// Returns the marks of a model as a sheet of that rubric.
[[nodiscard]] Sheet evaluationSheet(const EvaluationFormModel& model);

/// Returns the campaigns that include the actor, oldest first. kEvaluationSubmit.
[[nodiscard]] std::vector<EvaluationForm> evaluationForms(SessionContext& session);
/// Loads the recording of one model under its hidden label, like loadBlindedRecording(); nothing shown
/// identifies the model. For a demonstration without recordings, computes an expert's run of the model on the
/// forearm, which takes seconds: call it from a worker thread. kEvaluationSubmit, the actor's form. Throws
/// Error{kPermission} if the actor is not included, {kBadData} for an unknown label or a model without a
/// recording, {kVerifyFailed} if the recording was changed.
[[nodiscard]] BlindedRecording loadEvaluationRecording(SessionContext& session, const CampaignId& campaignId,
                                                       const std::string& hiddenLabel);
/// Stores one mark of the draft, empty to remove it; on disk when the call returns. kEvaluationSubmit, the
/// actor's form. Throws Error{kPermission} if the actor is not included, {kBadData} for an unknown model or
/// index, a mark outside the scale, or a submitted model.
void saveEvaluationScore(SessionContext& session, const CampaignId& campaignId,
                         const std::string& hiddenLabel, std::size_t index,
                         std::optional<std::int64_t> score_steps);
/// Returns the viewing rules of evaluations, which are those of cases. kEvaluationSubmit.
[[nodiscard]] ViewingRules evaluationRules(SessionContext& session);
/// Checks the marks of a model like a sheet. `watched`: of its recording, with length 0 if it was not opened;
/// ignored without a recording. Pure function.
[[nodiscard]] SheetCheck checkEvaluation(const EvaluationForm& form, const EvaluationFormModel& model,
                                         const WatchLog& watched, const ViewingRules& rules);
/// Seals the marks of one model. `watched` is known only to the page: it is audited, not stored with the
/// draft. kEvaluationSubmit, the actor's form; audited. Throws Error{kBadData} naming the first index without
/// a mark, or if too little of the recording was watched.
void submitEvaluation(SessionContext& session, const CampaignId& campaignId, const std::string& hiddenLabel,
                      const WatchLog& watched);

}  // namespace torsio
