// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "sim/core/text.h"

namespace torsio {

/// A link to somebody who was invited, and the words around it, in the language of whoever sends.
struct MailedInvitation {
  UserId userId{};
  std::string subject{};
  std::string body{};
};

/// Whether links can be sent by mail: the centre has set a server, and the actor may see addresses.
[[nodiscard]] bool canMailInvitations(SessionContext& session);
/// Sends each to the address of its person by the mail server of the centre; `password`: of that server.
/// Returns for each what speaks against it, empty: taken. Audited: an entry for each that the server took,
/// without words and address. kUserManage and kPersonViewIdentity. Throws Error{kBadParameter} when the
/// centre has set no server, and what sendMail() throws. A worker thread.
[[nodiscard]] std::vector<Text> sendInvitations(SessionContext& session, const std::string& password,
                                                std::span<const MailedInvitation> mailed);

}  // namespace torsio
