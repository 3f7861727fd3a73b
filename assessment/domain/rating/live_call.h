// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"

namespace torsio {

/// A trainee called to the real arm at one occasion, which opens the raters' live sheets of this case.
struct LiveCall {
  LiveCallId id{};
  EnrolmentId enrolmentId{};
  std::string occasionCode{};
  std::string room{};
  std::string calledBy{};  ///< user id
  std::int64_t calledUtc_us = 0;
  std::optional<std::int64_t> endedUtc_us{};  ///< empty: the trainee is at the arm
  bool cancelled = false;                     ///< called by mistake: the sheets are closed again
};

/// A call as shown to a rater. Blinded: reveals neither trainee nor group nor stage.
struct CallNotice {
  AssignmentId assignmentId{};
  std::string room{};
  std::int64_t calledUtc_us = 0;
  bool open = false;  ///< the trainee is at the arm now
};

}  // namespace torsio
