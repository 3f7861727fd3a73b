// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"

namespace torsio {

/// What of this machine opens a desk.
struct DeskPlace {
  std::filesystem::path program{};  ///< torsio itself
  std::filesystem::path folder{};   ///< keeps the desk's own certificate, its log, and where it is open
};

/// How a desk shall be open.
struct DeskWish {
  bool otherMachines = true;  ///< false: this machine alone reaches it
  std::uint16_t port = 8443;
  /// PEM files; both empty: a certificate that this machine signs for itself. Not asked for by this machine
  /// alone.
  std::filesystem::path certificate{};
  std::filesystem::path key{};
  bool goesOn = false;  ///< also when this program has ended; else it ends with it
};

/// A desk that is open.
struct OpenReviewDesk {
  std::vector<std::string> addresses{};  ///< as browsers reach it
  std::string fingerprint{};             ///< SHA-256 of its certificate; empty: not encrypted
  bool goesOn = false;
};

/// Whether a desk is opened from the window at all: the record is a file of this machine, and `torsio serve`
/// is built for it. kSettingsEdit.
[[nodiscard]] bool mayOpenReviewDesk(SessionContext& session);
/// The desk of this record that is open on this machine under this account; nothing: none is. kSettingsEdit.
[[nodiscard]] std::optional<OpenReviewDesk> openReviewDesk(SessionContext& session, const DeskPlace& place);
/// Opens the desk (`torsio serve`) and waits until it answers or has given up, half a minute at most. The
/// address of invitations becomes its own where none was set. Audited as a change of the setting
/// "review_desk". kSettingsEdit. Throws Error{kBadParameter}: the port is taken, one of the two files is
/// missing, a desk is open already, the record lies on a server; {kFileUnreadable}: it did not open, with the
/// last line that it said.
void startReviewDesk(SessionContext& session, const DeskPlace& place, const DeskWish& wish);
/// Closes it and waits for its end; drafts are in the record. Does nothing where none is open. Audited.
/// kSettingsEdit.
void stopReviewDesk(SessionContext& session, const DeskPlace& place);

}  // namespace torsio
