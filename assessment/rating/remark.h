// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "sim/base/ids.h"

namespace torsio {

/// What somebody wrote at a time of a trial. Append-only.
struct Remark {
  RemarkId id{};
  TrialId trialId{};
  std::string author{};       ///< who: id of a user, or of a person who has none
  PersonId authorPersonId{};  ///< the person behind; empty: a user without one
  std::string purpose{};      ///< "bookmark" (one's own), "remark" (an expert's), "reply"
  std::string replyTo{};      ///< the remark that a reply answers; empty else
  std::int64_t tick = 0;
  std::int64_t time_us = 0;  ///< since the first tick
  std::string text{};        ///< empty: a mere mark, or erased with its author or trainee
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// Receipt: somebody has read a remark, and when first.
struct ReadReceipt {
  RemarkId remarkId{};
  std::string reader{};       ///< as Remark::author
  PersonId readerPersonId{};  ///< empty: a user without a person
  std::int64_t readUtc_us = 0;
};

/// A bookmark that was sent to a physician, with what came back. Append-only.
struct TraineeQuestion {
  RemarkId remarkId{};  ///< the trainee's bookmark: moment and words
  RaterId raterId{};
  std::int64_t askedUtc_us = 0;
  TrialId trialId{};    ///< of the bookmark, as what follows; not written by add()
  PersonId personId{};  ///< who asks
  std::int64_t time_us = 0;
  std::string text{};   ///< empty: none, or erased
  RemarkId answerId{};  ///< the rater's first reply; empty: it still waits
  std::string answerText{};
  std::int64_t answeredUtc_us = 0;
};

}  // namespace torsio
