// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace torsio {

/// What somebody wrote at a time of a trial. Append-only.
struct Remark {
  std::string id{};
  std::string trialId{};
  std::string author{};          ///< who: id of a user, or of a person who has none
  std::string authorPersonId{};  ///< the person behind; empty: a user without one
  std::string purpose{};         ///< "bookmark" (one's own), "remark" (an expert's), "reply"
  std::string replyTo{};         ///< the remark that a reply answers; empty else
  std::int64_t tick = 0;
  std::int64_t time_us = 0;  ///< since the first tick
  std::string text{};        ///< empty: a mere mark, or erased with its author or trainee
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// Receipt: somebody has read a remark, and when first.
struct ReadReceipt {
  std::string remarkId{};
  std::string reader{};          ///< as Remark::author
  std::string readerPersonId{};  ///< empty: a user without a person
  std::int64_t readUtc_us = 0;
};

/// A bookmark that was sent to a physician, with what came back. Append-only.
struct TraineeQuestion {
  std::string remarkId{};  ///< the trainee's bookmark: moment and words
  std::string raterId{};
  std::int64_t askedUtc_us = 0;
  std::string trialId{};   ///< of the bookmark, as what follows; not written by add()
  std::string personId{};  ///< who asks
  std::int64_t time_us = 0;
  std::string text{};      ///< empty: none, or erased
  std::string answerId{};  ///< the rater's first reply; empty: it still waits
  std::string answerText{};
  std::int64_t answeredUtc_us = 0;
};

}  // namespace torsio
