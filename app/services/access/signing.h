// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/people/signature.h"
#include "sim/core/error.h"

namespace torsio {

class Connection;

/// Name of the setting: for how many minutes a password that was shown is good for signing; 0: once.
inline constexpr const char* kSignMinutesSetting = "sign_minutes";
inline constexpr int kDefaultSignMinutes = 15;
inline constexpr int kLongestSignMinutes = 60;

/// Actor::passwordShownUtc_us of an administrator who entered as a simulated person: there is no password
/// that anybody knows, and such an account signs only what is simulated.
inline constexpr std::int64_t kNoPasswordToShow = -1;

/// For how many minutes a password that was shown signs; 0: each signature asks anew, also the first one
/// after a sign-in.
[[nodiscard]] int signMinutes(Connection& connection);
/// Audited. kSettingsEdit. Throws Error{kBadParameter} outside 0 to kLongestSignMinutes.
void setSignMinutes(SessionContext& session, int minutes);

/// Whether the next signature asks for the password first.
[[nodiscard]] bool passwordIsDue(SessionContext& session);
/// The actor's own password, to sign with. A failure counts as one at the sign-in and is audited. Throws
/// Error{kPermission} when it is wrong, or must not be tried yet.
void showPassword(SessionContext& session, const std::string& password);

/// Thrown by a service that seals something: passwordIsDue().
class PasswordDue : public Error {
 public:
  PasswordDue();
};

/// What is signed, and what the signature means.
struct SignedObject {
  SignedKind kind = SignedKind::kTrainingMark;
  std::string objectId{};
  SignatureMeaning meaning = SignatureMeaning::kScored;
  std::string reason{};
  bool demonstration = false;
};
/// For a service, inside the transaction that seals the object and after it has asked for its right: stores
/// the actor's signature, audited. Throws PasswordDue.
void sign(SessionContext& session, const SignedObject& object);
/// Uses up the password where each signature asks for it. After the last sign() of one act.
void endSigning(SessionContext& session);

}  // namespace torsio
