// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// Acts that need two people: one requests, another confirms.
enum class DutyAct : std::uint8_t {
  kResetPassword,     ///< of an account with scoring or study rights; subject: the user
  kGrantRoles,        ///< any role except trainee; subject: the user
  kErase,             ///< subject: the person
  kRestore,           ///< subject: the hash of the backup
  kRevealAllocation,  ///< subject: the design
  kOnePerson,         ///< switch off the two-person rule
  kInvite,            ///< invitation link for an account with scoring or study rights; subject: the user
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
