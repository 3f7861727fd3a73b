// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "app/services/access/access_service.h"
#include "app/services/access/session_context.h"

namespace torsio::gui {

inline constexpr const char* kAdminPassword = "a short sentence for the lab";

/// Founds a centre in the record at `locator`. Returns the session of its administrator "admin", signed in.
[[nodiscard]] inline std::unique_ptr<SessionContext> foundCentre(const std::string& locator) {
  SessionKey key{.locator = locator, .station = "test"};
  auto office = std::make_unique<SessionContext>(key);
  office->setPasswordCost(PasswordCost::kTest);
  FirstRun first{.centre = "City hospital", .login = "admin", .password = kAdminPassword};
  setUpCentre(*office, first);
  EXPECT_EQ(torsio::signIn(*office, "admin", kAdminPassword).outcome, SignIn::kOk);
  return office;
}

}  // namespace torsio::gui
