// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// Meaning of a signature.
enum class SignatureMeaning : std::uint8_t { kScored, kAmended, kFroze };
inline constexpr std::array<Term<SignatureMeaning>, 3> kSignatureMeanings{{
    {SignatureMeaning::kScored, "scored", Text::tr("I scored this case")},
    {SignatureMeaning::kAmended, "amended", Text::tr("I changed my mark of this case")},
    {SignatureMeaning::kFroze, "froze", Text::tr("I froze these data")},
}};
[[nodiscard]] constexpr const auto& termsOf(SignatureMeaning) noexcept {
  return kSignatureMeanings;
}

/// Kinds of signed objects.
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

}  // namespace torsio
