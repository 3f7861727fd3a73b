// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/ids.h"

namespace torsio {

using PersonId = Id<struct PersonIdTag>;
using TraineeId = PersonId;  ///< a person with a row in table trainee
using RaterId = PersonId;    ///< a person with a row in table rater
using UserId = Id<struct UserIdTag>;

// The study.
using CentreId = Id<struct CentreIdTag>;
using CohortId = Id<struct CohortIdTag>;
using GroupId = Id<struct GroupIdTag>;
using EnrolmentId = Id<struct EnrolmentIdTag>;
using DesignId = Id<struct DesignIdTag>;          ///< of an allocation
using AllocationId = Id<struct AllocationIdTag>;  ///< one person put into one group
using ExposureId = Id<struct ExposureIdTag>;
using DeviationId = Id<struct DeviationIdTag>;
using ImportId = Id<struct ImportIdTag>;  ///< of an imported study
using FreezeId = Id<struct FreezeIdTag>;  ///< of a frozen data set

// The curriculum. While it is being written, modules and arms carry their codes in place of ids.
using CurriculumId = Id<struct CurriculumIdTag>;
using CurriculumVersionId = Id<struct CurriculumVersionIdTag>;
using ModuleId = Id<struct ModuleIdTag>;
using ArmId = Id<struct ArmIdTag>;
using PhaseId = Id<struct PhaseIdTag>;

// Recordings and remarks on them.
using RemarkId =
    Id<struct RemarkIdTag>;  ///< a bookmark, a remark or a reply; a question is a bookmark that was sent
using SelfScoreId = Id<struct SelfScoreIdTag>;

// Judging.
using RubricId = Id<struct RubricIdTag>;
using RubricRevisionId = Id<struct RubricRevisionIdTag>;
using AssignmentId = Id<struct AssignmentIdTag>;
using LiveCallId = Id<struct LiveCallIdTag>;  ///< one trainee called to the real arm, once
using MarkId = Id<struct MarkIdTag>;
using CalibrationScoreId = Id<struct CalibrationScoreIdTag>;
using CampaignId = Id<struct CampaignIdTag>;
using EvaluationMarkId = Id<struct EvaluationMarkIdTag>;
using RunId = Id<struct RunIdTag>;  ///< of one computation of results

}  // namespace torsio
