// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

enum class SignatureMeaning : std::uint8_t { kScored, kAmended, kFroze };
inline constexpr std::array<Term<SignatureMeaning>, 3> kSignatureMeanings{{
    {SignatureMeaning::kScored, "scored", Text::tr("I scored this case")},
    {SignatureMeaning::kAmended, "amended", Text::tr("I changed my mark of this case")},
    {SignatureMeaning::kFroze, "froze", Text::tr("I froze these data")},
}};
[[nodiscard]] constexpr const auto& termsOf(SignatureMeaning) noexcept {
  return kSignatureMeanings;
}

enum class SignedKind : std::uint8_t { kTrainingMark, kEvaluationMark, kFrozenDataset };
inline constexpr std::array<Term<SignedKind>, 3> kSignedKinds{{
    {SignedKind::kTrainingMark, "training_mark", Text::tr("mark")},
    {SignedKind::kEvaluationMark, "evaluation_mark", Text::tr("evaluation mark")},
    {SignedKind::kFrozenDataset, "frozen_dataset", Text::tr("frozen data set")},
}};
[[nodiscard]] constexpr const auto& termsOf(SignedKind) noexcept {
  return kSignedKinds;
}

/// A signature on a sealed object: who, when, meaning and reason. Append-only.
struct Signature {
  SignedKind kind = SignedKind::kTrainingMark;
  std::string objectId{};
  UserId userId{};
  PersonId personId{};  ///< empty: the user is not a person of the record
  SignatureMeaning meaning = SignatureMeaning::kScored;
  std::string reason{};
  std::int64_t signedUtc_us = 0;
  std::int64_t passwordShownUtc_us = 0;  ///< when the signer last entered the password
  bool demonstration = false;
};

/// Acts that need two people: one requests, another confirms.
enum class DutyAct : std::uint8_t {
  kResetPassword,     ///< of an account with scoring or study rights; subject: the user
  kGrantRoles,        ///< any role except trainee; subject: the user
  kErase,             ///< subject: the person
  kRestore,           ///< subject: the hash of the backup
  kRevealAllocation,  ///< subject: the design
  kOnePerson,         ///< switch off the two-person rule
  kInvite,            ///< invitation link for an account with scoring or study rights; subject: the user
  kFreezeInterim,     ///< freeze a cohort of which sheets are missing; subject: the cohort
  kEnd,               ///< number of acts
};
inline constexpr auto kDutyActs = std::to_array<Term<DutyAct>>({
    {DutyAct::kResetPassword, "reset_password", Text::tr("New start password")},
    {DutyAct::kGrantRoles, "grant_roles", Text::tr("Roles")},
    {DutyAct::kErase, "erase", Text::tr("Erase a person")},
    {DutyAct::kRestore, "restore", Text::tr("Restore a backup")},
    {DutyAct::kRevealAllocation, "reveal_allocation", Text::tr("Open the allocation")},
    {DutyAct::kOnePerson, "one_person", Text::tr("One person is enough from now on")},
    {DutyAct::kInvite, "invite", Text::tr("Invitation")},
    {DutyAct::kFreezeInterim, "freeze_interim", Text::tr("Freeze an interim state")},
});
[[nodiscard]] constexpr const auto& termsOf(DutyAct) noexcept {
  return kDutyActs;
}
static_assert(isWholeTable(kDutyActs, DutyAct::kEnd), "each act has one row, at its own place");

/// Outcome of a request.
enum class DutyDecision : std::uint8_t { kConfirmed, kRefused, kWithdrawn };
inline constexpr std::array<Term<DutyDecision>, 3> kDutyDecisions{{
    {DutyDecision::kConfirmed, "confirmed", Text::tr("confirmed")},
    {DutyDecision::kRefused, "refused", Text::tr("refused")},
    {DutyDecision::kWithdrawn, "withdrawn", Text::tr("withdrawn")},
}};
[[nodiscard]] constexpr const auto& termsOf(DutyDecision) noexcept {
  return kDutyDecisions;
}

/// A request for an act that needs two people. Append-only.
struct DutyRequest {
  std::string id{};
  DutyAct act = DutyAct::kResetPassword;
  std::string subject{};
  std::string detailJson{};
  std::string reason{};
  UserId requestedBy{};
  std::int64_t requestedUtc_us = 0;
};

}  // namespace torsio
