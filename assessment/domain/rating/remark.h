// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"

namespace torsio {

/// A remark at a moment of a trial. Append-only.
struct Remark {
  RemarkId id{};
  TrialId trialId{};
  std::string author{};       ///< id of a user, or of a person without an account
  PersonId authorPersonId{};  ///< the author's person; empty: a user who is not a person of the record
  std::string purpose{};      ///< "bookmark" (private), "remark" (by an expert), "reply"
  std::string replyTo{};      ///< remark that a reply answers; otherwise empty
  std::int64_t tick = 0;
  std::int64_t time_us = 0;  ///< since the first tick
  std::string text{};        ///< current text; empty: a bare bookmark, or erased with its author or trainee
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
  std::int64_t version = 1;       ///< of the text, from 1. Not written by add(), nor is editedUtc_us
  std::int64_t editedUtc_us = 0;  ///< when the current text was written; 0: never edited
};

/// A new text of a remark; the old ones are kept. Append-only.
struct RemarkRevision {
  RemarkId remarkId{};
  std::int64_t version = 2;
  std::string author{};       ///< as Remark::author
  PersonId authorPersonId{};  ///< as Remark::authorPersonId
  std::string text{};
  std::int64_t createdUtc_us = 0;
};

/// A superseded text of a remark.
struct RemarkWording {
  std::string text{};
  std::int64_t writtenUtc_us = 0;
};

/// Makes the next version of a remark from its author's new text. Throws Error: kPermission unless `author`
/// or `authorPersonId` wrote the remark; kBadParameter for blank or unchanged text, or a remark without text
/// (a bare bookmark, or erased).
[[nodiscard]] RemarkRevision revisionOf(const Remark& remark, const std::string& author,
                                        const PersonId& authorPersonId, const std::string& text,
                                        std::int64_t now_us);
/// Returns the JSON note of a revision for the audit trail: its version, never its text.
[[nodiscard]] std::string revisionNote(const RemarkRevision& revision);

/// Read receipt: who read which version of a remark, and when first.
struct ReadReceipt {
  RemarkId remarkId{};
  std::int64_t version = 1;
  std::string reader{};       ///< as Remark::author
  PersonId readerPersonId{};  ///< empty: a user who is not a person of the record
  std::int64_t readUtc_us = 0;
};

/// A bookmark sent to a physician as a question, with the reply. Append-only.
struct TraineeQuestion {
  RemarkId remarkId{};  ///< the trainee's bookmark: moment and words
  RaterId raterId{};
  std::int64_t askedUtc_us = 0;
  TrialId trialId{};    ///< of the bookmark, like the members below; not written by add()
  PersonId personId{};  ///< who asked
  std::int64_t time_us = 0;
  std::string text{};        ///< empty: none, or erased
  RemarkId answerId{};       ///< the rater's first reply; empty: unanswered
  std::string answerText{};  ///< its current text
  std::int64_t answeredUtc_us = 0;
  std::int64_t answerEditedUtc_us = 0;  ///< 0: never edited
};

}  // namespace torsio
