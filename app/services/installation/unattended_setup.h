// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/services/access/start_password.h"
#include "app/services/base/key_file.h"

namespace torsio {

inline constexpr std::string_view kAnsweredCentre = "centre";
inline constexpr std::string_view kAnsweredCode = "centre.code";
inline constexpr std::string_view kAnsweredLanguage = "language";
inline constexpr std::string_view kAnsweredAdministrator = "administrator";
inline constexpr std::string_view kAnsweredFirstSignIn = "administrator.first-sign-in";
inline constexpr std::string_view kAnsweredBrowserAddress = "browser-address";
inline constexpr std::string_view kAnsweredAccount = "account";
inline constexpr std::string_view kAnsweredTrainees = "roster.trainees";
inline constexpr std::string_view kAnsweredRaters = "roster.raters";
inline constexpr std::string_view kAnsweredRosterAccounts = "roster.accounts";

/// The keys of an answers file; docs/deployment.md lists them.
inline constexpr std::array kAnswerKeys{FileKey{kAnsweredCentre},
                                        FileKey{kAnsweredCode},
                                        FileKey{kAnsweredLanguage, ConfiguredKind::kLanguageCode},
                                        FileKey{kAnsweredAdministrator},
                                        FileKey{kAnsweredFirstSignIn},
                                        FileKey{kAnsweredBrowserAddress},
                                        FileKey{kAnsweredAccount, ConfiguredKind::kWords, true},
                                        FileKey{kAnsweredTrainees},
                                        FileKey{kAnsweredRaters},
                                        FileKey{kAnsweredRosterAccounts, ConfiguredKind::kYesNo}};

/// What a setup made. Secrets are shown once: the record keeps only their hashes.
struct SetUpRecord {
  std::string centre{};
  std::string code{};  ///< of the centre
  std::string administrator{};
  std::string link{};                  ///< with which the first administrator chooses a password; empty: none
  std::int64_t linkExpiresUtc_us = 0;  ///< 0 without a link
  std::vector<StartAccount> accounts{};  ///< the first administrator's comes first, unless there is a link
  std::size_t trainees = 0;              ///< added from the roster
  std::size_t raters = 0;
};

/// Sets up the record at `locator`, which is created if missing, from a file of answers, as the first-run
/// wizard does from a person's: by the same services, all or nothing. Tries the answers first, so that
/// refused ones leave no trace. Throws Error{kPermission} if the record has a centre, Error{kBadData} with
/// file and line for an answer that cannot be read or that a service refuses, DbError.
[[nodiscard]] SetUpRecord setUpRecord(const std::string& locator, const std::filesystem::path& answers);

/// Tries answers, rosters included, in a record in memory that is thrown away. Throws like setUpRecord().
void tryAnswers(const std::filesystem::path& answers);

}  // namespace torsio
