// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/training/next_steps.h"
#include "assessment/attempt/competence.h"
#include "assessment/domain/ids.h"

namespace torsio {

struct TranscriptModule {
  ModuleStep step{};
  std::vector<Attempt> attempts{};  ///< every one, oldest first
  CompetenceVerdict competence{};
};

/// A trainee's transcript.
struct Transcript {
  std::string centre{};
  std::string fullName{};  ///< the trainee's; empty: unknown to this record
  std::string traineeCode{};
  std::string cohortName{};
  std::string armLabel{};
  bool demonstration = false;
  std::int64_t madeUtc_us = 0;
  std::string softwareVersion{};
  std::vector<TranscriptModule> modules{};
  std::vector<RealArmRun> realArm{};  ///< oldest first
  double virtual_min = 0.0;
  double real_min = 0.0;
  double rest_min = 0.0;
};
/// kTrialViewOwn, the actor's person. Audited, since it may leave the centre.
[[nodiscard]] Transcript transcript(SessionContext& session, const PersonId& personId);

}  // namespace torsio
