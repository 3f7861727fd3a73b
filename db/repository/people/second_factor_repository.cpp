// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/second_factor_repository.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

#include "db/connection/row_reader.h"
#include "db/repository/people/stored_password.h"

namespace torsio {

namespace {

/// What is kept of a recovery code: 79 random bits (legibleLetters()) need no slow hash.
std::string keptOfRecoveryCode(const UserId& userId, const std::string& code) {
  std::string plain;
  for (const char letter : code) {
    if (letter != ' ' && letter != '-') {
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
  }
  return keptOfProof("torsio recovery code " + userId.text() + " " + plain);
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) {
    words.push_back(std::move(word));
  }
  return words;
}

std::string inOneText(std::span<const std::string> words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

}  // namespace

std::optional<SecondFactor> SecondFactorRepository::find(const UserId& userId) const {
  return selectFirst(connection_,
                     "SELECT s.sealed, f.last_step, f.recovery_codes FROM second_factor f"
                     " JOIN second_factor_secret s ON s.user_id = f.user_id WHERE f.user_id = ?",
                     {userId}, [](RowReader& row) {
                       return SecondFactor{row.text(), row.int64(), wordsOf(row.text()).size()};
                     });
}

std::vector<UserId> SecondFactorRepository::owners() const {
  return selectAll(connection_, "SELECT user_id FROM second_factor ORDER BY user_id", {}, readId<UserId>);
}

void SecondFactorRepository::add(const UserId& userId, const std::string& sealed, std::int64_t lastStep,
                                 std::span<const std::string> recoveryCodes, std::int64_t utc_us) {
  std::vector<std::string> kept;
  for (const std::string& code : recoveryCodes) {
    kept.push_back(keptOfRecoveryCode(userId, code));
  }
  Transaction transaction(connection_);
  connection_.execute(insertInto("second_factor", "user_id, made_utc_us, last_step, recovery_codes"),
                      {userId, utc_us, lastStep, inOneText(kept)});
  connection_.execute(insertInto("second_factor_secret", "user_id, sealed"), {userId, sealed});
  transaction.commit();
}

void SecondFactorRepository::reseal(const UserId& userId, const std::string& sealed) {
  connection_.execute("UPDATE second_factor_secret SET sealed = ? WHERE user_id = ?", {sealed, userId});
}

bool SecondFactorRepository::useStep(const UserId& userId, std::int64_t step) {
  return connection_.execute("UPDATE second_factor SET last_step = ? WHERE user_id = ? AND last_step < ?",
                             {step, userId, step}) == 1;
}

bool SecondFactorRepository::useRecoveryCode(const UserId& userId, const std::string& code) {
  const std::string stored =
      selectFirst(connection_, "SELECT recovery_codes FROM second_factor WHERE user_id = ?", {userId},
                  readText)
          .value_or("");
  std::vector<std::string> kept = wordsOf(stored);
  if (std::erase(kept, keptOfRecoveryCode(userId, code)) == 0) {
    return false;
  }
  return connection_.execute(
             "UPDATE second_factor SET recovery_codes = ? WHERE user_id = ? AND recovery_codes = ?",
             {inOneText(kept), userId, stored}) == 1;
}

bool SecondFactorRepository::remove(const UserId& userId) {
  return connection_.execute("DELETE FROM second_factor WHERE user_id = ?", {userId}) > 0;
}

}  // namespace torsio
