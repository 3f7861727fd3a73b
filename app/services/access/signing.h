// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/people/signature.h"
#include "sim/core/error.h"

namespace torsio {

/// Actor::passwordShownUtc_us of an administrator who entered as a simulated person: there is no password
/// that anybody knows, and such an account signs only what is simulated.
inline constexpr std::int64_t kNoPasswordToShow = -1;

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
