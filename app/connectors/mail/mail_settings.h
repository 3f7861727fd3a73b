// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/connectors/mail/smtp_client.h"
#include "app/services/access/session_context.h"

namespace torsio {

/// The centre's mail server. Its password is never stored; the sender enters it.
struct MailSettings {
  MailServer server{};
  std::string from{};  ///< address of the sender
};

/// Empty: not set. kStudySetup.
[[nodiscard]] std::optional<MailSettings> mailSettings(SessionContext& session);
/// An empty host removes it. Audited. kSettingsEdit. Throws Error{kBadParameter} for an invalid address, a
/// host with spaces, or a server on another computer without encryption.
void setMailSettings(SessionContext& session, const MailSettings& settings);

}  // namespace torsio
