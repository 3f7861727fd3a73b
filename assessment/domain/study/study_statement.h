// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// What a study says about itself and nobody can compute from the record.
enum class StudyItem : std::uint8_t {
  kRegistration,
  kProtocol,
  kEthics,
  kPlace,
  kEligibility,
  kRecruitment,
  kSampleSize,
  kHarms,
  kFunding,
  kInterests,
  kDataAccess,
  kInvolvement,
  kEnd,  ///< number of items
};
inline constexpr auto kStudyItems = std::to_array<Term<StudyItem>>({
    {StudyItem::kRegistration, "registration", Text::tr("Registration")},
    {StudyItem::kProtocol, "protocol", Text::tr("Protocol and plan of the analysis")},
    {StudyItem::kEthics, "ethics", Text::tr("Ethics approval")},
    {StudyItem::kPlace, "place", Text::tr("Place")},
    {StudyItem::kEligibility, "eligibility", Text::tr("Eligibility")},
    {StudyItem::kRecruitment, "recruitment", Text::tr("Recruitment")},
    {StudyItem::kSampleSize, "sample_size", Text::tr("Sample size")},
    {StudyItem::kHarms, "harms", Text::tr("Harms")},
    {StudyItem::kFunding, "funding", Text::tr("Funding")},
    {StudyItem::kInterests, "interests", Text::tr("Interests")},
    {StudyItem::kDataAccess, "data_access", Text::tr("Access to data")},
    {StudyItem::kInvolvement, "involvement", Text::tr("Involvement of patients or the public")},
});
[[nodiscard]] constexpr const auto& termsOf(StudyItem) noexcept {
  return kStudyItems;
}
static_assert(isWholeTable(kStudyItems, StudyItem::kEnd), "each item has one row, at its own place");

/// What to state, by item.
inline constexpr std::array<Phrase, static_cast<std::size_t>(StudyItem::kEnd)> kStudyItemHints{
    Text::tr("registry, number and date"),
    Text::tr("where both can be read"),
    Text::tr("committee, number and date"),
    Text::tr("hospital or school, town and country"),
    Text::tr("who could take part, and who could not"),
    Text::tr("first and last day of recruitment and of follow-up"),
    Text::tr("how the number of trainees was chosen, with its assumptions"),
    Text::tr("how they were looked for, and which there were"),
    Text::tr("who paid or supplied, and their part in the study"),
    Text::tr("of the authors, also in the simulator and its makers"),
    Text::tr("where coded data, codebook and programs can be had"),
    Text::tr("in design, conduct and report; or that there was none"),
};
[[nodiscard]] constexpr Phrase hintOf(StudyItem item) noexcept {
  return kStudyItemHints[static_cast<std::size_t>(item)];
}

/// One version of a statement. Append-only; the newest of an item counts.
struct StudyStatement {
  CohortId cohortId{};
  StudyItem item = StudyItem::kRegistration;
  std::string statement{};  ///< empty: taken back
  UserId statedBy{};
  std::int64_t statedUtc_us = 0;
};
/// What counts; items without a statement are absent.
using StudyStatements = std::map<StudyItem, std::string>;

}  // namespace torsio
