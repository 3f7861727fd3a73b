// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// The purpose without which nothing is recorded.
inline constexpr const char* kTrainingRecord = "training_record";

/// How a decision was given.
enum class ConsentForm : std::uint8_t { kScreen, kPaper };
inline constexpr std::array<Term<ConsentForm>, 2> kConsentForms{{
    {ConsentForm::kScreen, "screen", Text::tr("on the screen"), "decided by the person at a station"},
    {ConsentForm::kPaper, "paper", Text::tr("on paper"), "signed, and entered by an administrator"},
}};
[[nodiscard]] constexpr const auto& termsOf(ConsentForm) noexcept {
  return kConsentForms;
}

/// What somebody agrees to, in the words that are shown.
struct ConsentText {
  std::string purpose{};  ///< kTrainingRecord, "video", ... or one that the centre added
  std::string title{};
  std::string text{};
};

/// The words of one version in one language, in the order in which they are asked.
struct ConsentWords {
  std::string language{};  ///< "en", "zh_CN", or another that the centre writes for
  std::vector<ConsentText> texts{};
};

/// What is asked of everybody until the next version. Never changes once published.
struct ConsentVersion {
  std::string id{};  ///< stored with each decision: "2026-1" as it ships, "centre-1" of the centre's own
  std::int64_t number = 0;                ///< 0: as it ships
  std::string note{};                     ///< what changed
  std::vector<ConsentWords> languages{};  ///< each has the purposes of the others in their order
  std::string publishedBy{};
  std::int64_t publishedUtc_us = 0;
};

/// A person's decision about one purpose. Append-only: the newest one counts.
struct ConsentDecision {
  PersonId personId{};
  std::string purpose{};  ///< of a ConsentText
  bool granted = false;
  std::string textVersion{};  ///< of the text that was shown
  std::int64_t decidedUtc_us = 0;
  std::string recordedBy{};
  bool demonstration = false;
  ConsentForm form = ConsentForm::kScreen;
  std::int64_t signedUtc_us = 0;  ///< on paper: the day beside the signature; else 0
};

}  // namespace torsio
