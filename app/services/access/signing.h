// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/people/signature.h"
#include "sim/core/error.h"

namespace torsio {

/// Actor::passwordShownUtc_us of an administrator acting as a simulated person: nobody knows a password, and
/// such an account signs only simulated objects.
inline constexpr std::int64_t kNoPasswordToShow = -1;

/// Returns whether the next signature must ask for the password.
[[nodiscard]] bool passwordIsDue(SessionContext& session);
/// Enters the actor's own password for signing. A failure counts and is audited like one at sign-in. Throws
/// Error{kPermission} if it is wrong or must not be tried yet.
void showPassword(SessionContext& session, const std::string& password);

/// Thrown by a service that needs a signature while passwordIsDue().
class PasswordDue : public Error {
 public:
  PasswordDue();
};

/// The object to sign, and the meaning of the signature.
struct SignedObject {
  SignedKind kind = SignedKind::kTrainingMark;
  std::string objectId{};
  SignatureMeaning meaning = SignatureMeaning::kScored;
  std::string reason{};
  bool demonstration = false;
};
/// Stores the actor's signature, audited. For services, inside the transaction that seals the object and
/// after checking the right. Throws PasswordDue.
void sign(SessionContext& session, const SignedObject& object);
/// Uses up the password if each signature asks for it. Call after the last sign() of an act.
void endSigning(SessionContext& session);

}  // namespace torsio
