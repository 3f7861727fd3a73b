// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"

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
  std::string text{};        ///< the newest words; empty: a mere mark, or erased with its author or trainee
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
  std::int64_t version = 1;       ///< of the words; 1: as first written. Not written by add(), nor the next
  std::int64_t editedUtc_us = 0;  ///< when the newest words were written; 0: never edited
};

/// New words of a remark, beside the old ones. Append-only.
struct RemarkRevision {
  RemarkId remarkId{};
  std::int64_t version = 2;
  std::string author{};       ///< as Remark::author
  PersonId authorPersonId{};  ///< as Remark::authorPersonId
  std::string text{};
  std::int64_t createdUtc_us = 0;
};

/// Words of a remark that newer ones have replaced.
struct RemarkWording {
  std::string text{};
  std::int64_t writtenUtc_us = 0;
};

/// Makes the next version of a remark in the words of its author. Throws Error: kPermission unless `author`
/// or `authorPersonId` wrote the remark; kBadParameter for words that are blank or the same, and for a remark
/// that has none (a mere bookmark, or erased).
[[nodiscard]] RemarkRevision revisionOf(const Remark& remark, const std::string& author,
                                        const PersonId& authorPersonId, const std::string& text,
                                        std::int64_t now_us);
/// What the audit trail tells of a revision beside who and when: its version, never its words. JSON.
[[nodiscard]] std::string revisionNote(const RemarkRevision& revision);

/// Receipt: somebody has read a version of a remark, and when first.
struct ReadReceipt {
  RemarkId remarkId{};
  std::int64_t version = 1;
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
  std::string text{};        ///< empty: none, or erased
  RemarkId answerId{};       ///< the rater's first reply; empty: it still waits
  std::string answerText{};  ///< the newest words
  std::int64_t answeredUtc_us = 0;
  std::int64_t answerEditedUtc_us = 0;  ///< 0: never edited
};

}  // namespace torsio
