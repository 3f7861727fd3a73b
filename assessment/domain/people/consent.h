// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// Purpose without whose consent nothing is recorded.
inline constexpr const char* kTrainingRecord = "training_record";

/// Medium of a decision.
enum class ConsentForm : std::uint8_t { kScreen, kPaper };
inline constexpr std::array<Term<ConsentForm>, 2> kConsentForms{{
    {ConsentForm::kScreen, "screen", Text::tr("on the screen"), "decided by the person at a station"},
    {ConsentForm::kPaper, "paper", Text::tr("on paper"), "signed, and entered by an administrator"},
}};
[[nodiscard]] constexpr const auto& termsOf(ConsentForm) noexcept {
  return kConsentForms;
}

/// One purpose of consent with the text that is shown.
struct ConsentText {
  std::string purpose{};  ///< kTrainingRecord, "video", ... or one added by the centre
  std::string title{};
  std::string text{};
};

/// The texts of one version in one language, in the order in which they are asked.
struct ConsentWords {
  std::string language{};  ///< "en", "zh_CN", or any other language that the centre provides
  std::vector<ConsentText> texts{};
};

/// A version of the consent texts, in force until the next one. Never changes once published.
struct ConsentVersion {
  std::string id{};  ///< stored with each decision: "2026-1" as shipped, "centre-1" for the centre's own
  std::int64_t number = 0;                ///< 0: as shipped
  std::string note{};                     ///< what changed
  std::vector<ConsentWords> languages{};  ///< all with the same purposes in the same order
  std::string publishedBy{};
  std::int64_t publishedUtc_us = 0;
};

/// A person's decision about one purpose. Append-only; the newest one counts.
struct ConsentDecision {
  PersonId personId{};
  std::string purpose{};  ///< of a ConsentText
  bool granted = false;
  std::string textVersion{};  ///< of the text that was shown
  std::int64_t decidedUtc_us = 0;
  std::string recordedBy{};
  bool demonstration = false;
  ConsentForm form = ConsentForm::kScreen;
  std::int64_t signedUtc_us = 0;  ///< date of the signature on paper; otherwise 0
};

}  // namespace torsio
