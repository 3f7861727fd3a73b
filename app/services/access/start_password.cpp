// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/start_password.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include <QRandomGenerator>

namespace torsio {

namespace {

constexpr std::string_view kLegible = "abcdefghijkmnpqrstuvwxyz23456789";  // without the look-alikes l and 1,
                                                                           // o and 0
constexpr int kGroups = 4;
constexpr int kLettersInGroup = 5;

std::string randomGroups(int groups) {
  std::string password;
  for (int group = 0; group < groups; ++group) {
    if (group > 0) {
      password += '-';
    }
    password += legibleLetters(kLettersInGroup);
  }
  return password;
}

/// Returns the sign-in name, followed by the person's name where it is known.
Text ownerOf(const StartAccount& account) {
  return account.personName.empty() ? Text(account.login)
                                    : Text::tr("%1 (%2)", account.login, account.personName);
}

Text askers(std::span<const StartAccount> accounts) {
  std::set<std::string> names;
  for (const StartAccount& account : accounts) {
    names.insert(account.askedBy);
  }
  const std::vector<Text> texts(names.begin(), names.end());
  return listed(texts);
}

}  // namespace

std::string legibleLetters(int count) {
  std::string letters;
  for (int i = 0; i < count; ++i) {
    letters += kLegible[QRandomGenerator::system()->bounded(static_cast<quint32>(kLegible.size()))];
  }
  return letters;
}

std::string randomStartPassword() {
  return randomGroups(kGroups);
}

std::string randomHalfPassword() {
  return randomGroups(kGroups / 2);
}

std::string writtenPassword(const StartAccount& account) {
  switch (account.part) {
    case PasswordPart::kFirstHalf:
      return account.startPassword + "-\u2026";
    case PasswordPart::kSecondHalf:
      return "\u2026-" + account.startPassword;
    case PasswordPart::kWhole:
      break;
  }
  return account.startPassword;
}

Text partWords(const StartAccount& account) {
  switch (account.part) {
    case PasswordPart::kFirstHalf:
      return Text::tr("first half; the second comes from the administrator who confirms");
    case PasswordPart::kSecondHalf:
      return Text::tr("second half; the first comes from %1, who asked", account.askedBy);
    case PasswordPart::kWhole:
      break;
  }
  return Text::tr("whole");
}

Text handOverWords(const StartAccount& account) {
  switch (account.part) {
    case PasswordPart::kFirstHalf:
      return Text::tr(
          "This is the first half of the start password of %1. Give it to them; the second half comes from "
          "the administrator who confirms. It is shown only now.",
          ownerOf(account));
    case PasswordPart::kSecondHalf:
      return Text::tr(
          "This is the second half of the start password of %1, after the first half and a hyphen. Give it "
          "to them; the first half comes from %2, who asked. It is shown only now.",
          ownerOf(account), account.askedBy);
    case PasswordPart::kWhole:
      break;
  }
  return Text::tr(
      "Give this start password to %1. It is shown only now, and must be changed at the first sign-in.",
      ownerOf(account));
}

Text handOverWords(std::span<const StartAccount> accounts) {
  const auto count = [accounts](PasswordPart part) {
    return std::count_if(accounts.begin(), accounts.end(),
                         [part](const StartAccount& account) { return account.part == part; });
  };
  const auto all = static_cast<std::ptrdiff_t>(accounts.size());
  if (count(PasswordPart::kSecondHalf) == all && all > 0) {
    return Text::tr(
        "These are the second halves of start passwords. The first halves come from %1, who asked. They are "
        "shown only now. Give each to its owner, for example on a card in a sealed envelope. Everybody "
        "chooses their own password at the first sign-in.",
        askers(accounts));
  }
  const std::ptrdiff_t first = count(PasswordPart::kFirstHalf);
  if (first == 0) {
    return Text::tr(
        "These start passwords are shown only now. Give each to its owner, for example on a card in a sealed "
        "envelope. Everybody chooses their own password at the first sign-in.");
  }
  return Text::tr(
      "%1 of these %2 start passwords are only the first half. The second half comes from the administrator "
      "who confirms the request; nobody can sign in with one half. They are shown only now. Give each to its "
      "owner, for example on a card in a sealed envelope. Everybody chooses their own password at the first "
      "sign-in.",
      first, all);
}

Text cardWords(const StartAccount& account) {
  switch (account.part) {
    case PasswordPart::kFirstHalf:
      return Text::tr("First half. The second half comes from another administrator.");
    case PasswordPart::kSecondHalf:
      return Text::tr("Second half. The first half comes from %1.", account.askedBy);
    case PasswordPart::kWhole:
      break;
  }
  return Text::tr("Choose your own password at the first sign-in.");
}

Text envelopeWords(const StartAccount& account) {
  switch (account.part) {
    case PasswordPart::kFirstHalf:
      return Text::tr("First half of your password for Torsio. For you alone.");
    case PasswordPart::kSecondHalf:
      return Text::tr("Second half of your password for Torsio. For you alone.");
    case PasswordPart::kWhole:
      break;
  }
  return Text::tr("Your access to Torsio. For you alone.");
}

}  // namespace torsio
