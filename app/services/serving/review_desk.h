// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"

namespace torsio {

/// Paths for opening a desk on this machine.
struct DeskPlace {
  std::filesystem::path program{};  ///< the torsio program
  std::filesystem::path folder{};   ///< for the desk's certificate, log and state
};

/// Options for opening a desk.
struct DeskWish {
  bool otherMachines = true;  ///< false: reachable only from this machine
  std::uint16_t port = 8443;
  /// PEM files; if both are empty, a self-signed certificate. Not needed if only this machine can connect.
  std::filesystem::path certificate{};
  std::filesystem::path key{};
  bool goesOn = false;  ///< keep running after this program ends
};

/// An open desk.
struct OpenReviewDesk {
  std::vector<std::string> addresses{};  ///< URLs for browsers
  std::string fingerprint{};             ///< SHA-256 of the certificate; empty: unencrypted
  bool goesOn = false;
};

/// Returns whether the window can open a desk: the record is a file on this machine, and `torsio serve` is
/// available. kSettingsEdit.
[[nodiscard]] bool mayOpenReviewDesk(SessionContext& session);
/// Returns the open desk of this record on this machine and account; empty if there is none. kSettingsEdit.
[[nodiscard]] std::optional<OpenReviewDesk> openReviewDesk(SessionContext& session, const DeskPlace& place);
/// Opens the desk (`torsio serve`) and waits at most half a minute until it answers or fails. Sets the
/// address for invitations if it was not set. Audited as a change of the setting "review_desk".
/// kSettingsEdit. Throws Error{kBadParameter} if the port is in use, one of the two files is missing, a desk
/// is already open, or the record is on a server; {kFileUnreadable} if it failed to open, with its last
/// message.
void startReviewDesk(SessionContext& session, const DeskPlace& place, const DeskWish& wish);
/// Closes the desk and waits for its end; drafts are in the record. Does nothing if none is open. Audited.
/// kSettingsEdit.
void stopReviewDesk(SessionContext& session, const DeskPlace& place);

}  // namespace torsio
