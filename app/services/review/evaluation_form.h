// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/review/blinded_case.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"

namespace torsio {

/// The nine marks of one model (paper section 5.3). Only the hidden label tells which.
struct EvaluationFormModel {
  std::string hiddenLabel{};                          ///< "X"
  std::vector<std::optional<std::int64_t>> scores{};  ///< steps, one an index; drafts while not submitted
  bool submitted = false;
  bool recorded = false;  ///< there is something to watch (loadEvaluationRecording)
};

/// What one rater fills in, with the models in the order that was drawn for this rater. Neither names of the
/// models nor weights are in it.
struct EvaluationForm {
  CampaignId campaignId{};  ///< handle; never shown
  std::string title{};
  ScoreScale scale{};
  std::vector<std::string> indices{};   ///< names, in the instrument's order
  std::vector<std::string> indexIds{};  ///< of indexMeaning
  std::vector<EvaluationFormModel> models{};
  [[nodiscard]] bool complete() const noexcept;
};

/// The indices as rows of a rubric ("1" to "9"), so that the same sheet and the same keys serve; the meanings
/// are their anchors, the definitions their descriptions.
[[nodiscard]] RubricRevision evaluationRubric(const EvaluationForm& form);
/// The marks of a model as a sheet of that rubric.
[[nodiscard]] Sheet evaluationSheet(const EvaluationFormModel& model);

/// The campaigns that ask the actor, oldest first. kEvaluationSubmit.
[[nodiscard]] std::vector<EvaluationForm> evaluationForms(SessionContext& session);
/// Loads the recording of one model under its hidden label, as loadBlindedRecording does: nothing in it that
/// is shown tells the model. Of a demonstration without recordings an expert's run of the model on the
/// forearm is computed, which takes seconds: worker thread. kEvaluationSubmit, own form. Throws
/// Error{kPermission}: not asked, {kBadData}: unknown label or a model without a recording, {kVerifyFailed}:
/// the recording was changed.
[[nodiscard]] BlindedRecording loadEvaluationRecording(SessionContext& session, const CampaignId& campaignId,
                                                       const std::string& hiddenLabel);
/// Stores one mark of the draft, empty takes it back; it is on the disk when the call returns.
/// kEvaluationSubmit, own form. Throws Error{kPermission}: not asked, {kBadData}: unknown model or index, out
/// of the scale, or submitted already.
void saveEvaluationScore(SessionContext& session, const CampaignId& campaignId,
                         const std::string& hiddenLabel, std::size_t index,
                         std::optional<std::int64_t> score_steps);
/// Seals the marks of one model. kEvaluationSubmit, own form; audited. Throws Error{kBadData} naming the
/// first index without a mark.
void submitEvaluation(SessionContext& session, const CampaignId& campaignId, const std::string& hiddenLabel);

}  // namespace torsio
