// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/results/study_analysis.h"

// Parts of analyseStudy(), one per source file. Private to assessment/results.
namespace torsio {

/// Adds properties of the raters derived from their marks: agreement in points, number needed, severity on
/// one scale.
void addRaterModels(StudyAnalysis& study);
/// Adds the groups' gains; requires at least two occasions.
void addGains(const CohortInputs& inputs, StudyAnalysis& study);

}  // namespace torsio
