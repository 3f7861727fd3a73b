// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "sim/base/ids.h"

namespace torsio {

/// A person's decision about one purpose. Append-only: the newest one counts.
struct ConsentDecision {
  PersonId personId{};
  std::string purpose{};  ///< "training_record", "video", "research", "xapi_export", "teaching"
  bool granted = false;
  std::string textVersion{};  ///< of the text that was shown
  std::int64_t decidedUtc_us = 0;
  std::string recordedBy{};
  bool demonstration = false;
};

}  // namespace torsio
