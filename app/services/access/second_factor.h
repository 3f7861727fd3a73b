// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "app/services/access/access_service.h"
#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"

namespace torsio {

class Connection;

/// Returns whether the centre asks an account with these roles for a second factor (kSecondFactor). Without
/// permission.
[[nodiscard]] bool secondFactorIsAsked(Connection& connection, const std::vector<std::string>& roles);

/// What an authenticator app needs to make the codes of an account.
struct SecondFactorOffer {
  std::string secret{};  ///< base32
  std::string uri{};     ///< "otpauth://totp/...", for a QR code
};
/// Returns a fresh secret. Nothing is stored: switchOnSecondFactor() does that once a code of it is shown.
/// Without permission.
[[nodiscard]] SecondFactorOffer offerSecondFactor(SessionContext& session, const std::string& login);

/// What somebody enters to switch the second factor of their account on.
struct SecondFactorWish {
  std::string login{};
  std::string password{};
  std::string secret{};  ///< of an offer
  std::string code{};    ///< the six digits that the app shows for it
  std::string place{};   ///< see signIn()
};
struct SecondFactorStart {
  SignInAnswer answer{};                     ///< signed in
  std::vector<std::string> recoveryCodes{};  ///< ten, each good for one sign-in; shown only now
};
/// Seals the secret under the password, stores it and signs in; after kMustEnrol or on request. Audited.
/// Throws Error{kPermission} if the password is wrong or must be changed first, {kBadParameter} if the code
/// does not belong to the secret, {kBadData} if the account has a second factor.
[[nodiscard]] SecondFactorStart switchOnSecondFactor(SessionContext& session, const SecondFactorWish& wish);
/// Switches the actor's own off: for another phone, or for good. `code`: as at sign-in. Audited. Throws
/// Error{kPermission} if password or code is wrong, {kBadData} if there is none.
void switchOffSecondFactor(SessionContext& session, const std::string& password, const std::string& code);

struct OwnSecondFactor {
  bool on = false;
  bool asked = false;             ///< by the centre
  std::size_t recoveryCodes = 0;  ///< not used yet
};
/// Returns the actor's own. Without permission.
[[nodiscard]] OwnSecondFactor ownSecondFactor(SessionContext& session);

/// Returns the accounts that have a second factor. kUserManage.
[[nodiscard]] std::set<UserId> secondFactors(SessionContext& session);

}  // namespace torsio
