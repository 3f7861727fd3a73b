// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/connectors/mail/smtp_client.h"
#include "app/services/access/session_context.h"

namespace torsio {

/// The mail server of the centre. Its password is kept nowhere: whoever sends enters it.
struct MailSettings {
  MailServer server{};
  std::string from{};  ///< the address that messages come from
};

/// Empty: the centre has set none. kStudySetup.
[[nodiscard]] std::optional<MailSettings> mailSettings(SessionContext& session);
/// Without a host: takes it away. Audited. kSettingsEdit. Throws Error{kBadParameter}: an address that is
/// none, a host with blanks, a server elsewhere without encryption.
void setMailSettings(SessionContext& session, const MailSettings& settings);

}  // namespace torsio
