// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"

namespace torsio {

/// What a trainee answered to one's remark. Never who it was.
struct RemarkReply {
  RemarkId id{};
  std::string remark{};  ///< one's own words
  std::string text{};    ///< the newest words
  std::int64_t version = 1;
  std::int64_t time_us = 0;  ///< of the moment in the recording
};

/// Lists the answers to one's own remarks that were not read yet, oldest first. kTrialViewAssigned.
[[nodiscard]] std::vector<RemarkReply> repliesToMe(SessionContext& session);

/// Notes that one has read a version of an answer; audited. kTrialViewAssigned. Throws Error{kBadParameter}
/// for what is no unread answer to a remark of one's own.
void markReplyRead(SessionContext& session, const std::string& replyId, std::int64_t version);

}  // namespace torsio
