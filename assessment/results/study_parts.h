// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/results/study_analysis.h"

// Parts of analyseStudy(), one a source file. Private to assessment/results.
namespace torsio {

/// Adds what the raters' marks say of the raters: agreement in points, how many are needed, one scale.
void addRaterModels(StudyAnalysis& study);
/// Adds what the groups gained; there are two occasions or more.
void addGains(const CohortInputs& inputs, StudyAnalysis& study);

}  // namespace torsio
