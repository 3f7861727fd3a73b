// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// What people may request about their own record.
enum class PersonRequestKind : std::uint8_t {
  kExport,  ///< a copy of everything held about them
  kErase,   ///< deletion of name and recordings
  kEnd,     ///< number of kinds
};
inline constexpr auto kPersonRequestKinds = std::to_array<Term<PersonRequestKind>>({
    {PersonRequestKind::kExport, "export", Text::tr("a copy of everything kept")},
    {PersonRequestKind::kErase, "erase", Text::tr("erasing the record")},
});
[[nodiscard]] constexpr const auto& termsOf(PersonRequestKind) noexcept {
  return kPersonRequestKinds;
}
static_assert(isWholeTable(kPersonRequestKinds, PersonRequestKind::kEnd),
              "each kind has one row, at its own place");

/// Outcome of a request.
enum class PersonRequestAnswer : std::uint8_t { kDone, kDeclined, kTakenBack };
inline constexpr std::array<Term<PersonRequestAnswer>, 3> kPersonRequestAnswers{{
    {PersonRequestAnswer::kDone, "done", Text::tr("done")},
    {PersonRequestAnswer::kDeclined, "declined", Text::tr("declined")},
    {PersonRequestAnswer::kTakenBack, "taken_back", Text::tr("taken back")},
}};
[[nodiscard]] constexpr const auto& termsOf(PersonRequestAnswer) noexcept {
  return kPersonRequestAnswers;
}

/// One request of one person.
struct PersonRequest {
  std::string id{};
  PersonId personId{};
  PersonRequestKind kind = PersonRequestKind::kExport;
  std::int64_t askedUtc_us = 0;
  std::optional<PersonRequestAnswer> answer{};  ///< empty: pending
  std::string reason{};                         ///< of the answer
  std::int64_t answeredUtc_us = 0;
  std::string personCode{};  ///< filled when read
};

}  // namespace torsio
