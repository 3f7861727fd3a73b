// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sim/core/text.h"

namespace torsio {

/// One value of a protocol enumeration with its stored text and label.
template <typename Value>
struct Term {
  Value value;
  std::string_view stored;     ///< in the database and in files; released texts never change
  Phrase label;                ///< English label, the key of its translation
  std::string_view meaning{};  ///< one line for documents; empty where the label suffices
};

/// True if `table` has one row for each value below `end`, in order.
template <typename Value, std::size_t Size>
[[nodiscard]] constexpr bool isWholeTable(const std::array<Term<Value>, Size>& table, Value end) noexcept {
  for (std::size_t i = 0; i < Size; ++i) {
    if (static_cast<std::size_t>(table[i].value) != i || table[i].stored.empty() || table[i].label.empty()) {
      return false;
    }
  }
  return Size == static_cast<std::size_t>(end);
}

/// How a run of a module counts.
enum class AttemptMode : std::uint8_t { kPractice, kGraded };
inline constexpr std::array<Term<AttemptMode>, 2> kAttemptModes{{
    {AttemptMode::kPractice, "practice", Text::tr("Practice"),
     "may be repeated; counts towards modules for practice"},
    {AttemptMode::kGraded, "graded", Text::tr("Graded"),
     "counts towards every module and may be limited in number"},
}};

/// Where the time of a study phase is spent.
enum class PhaseKind : std::uint8_t { kVirtual, kReal };
inline constexpr std::array<Term<PhaseKind>, 2> kPhaseKinds{{
    {PhaseKind::kVirtual, "virtual", Text::tr("simulator"), "on the simulator; its runs are recorded"},
    {PhaseKind::kReal, "real", Text::tr("real arm"), "on the real forearm; its time is entered by hand"},
}};

/// Activity of an exposure. Rest stops the clock of the phases.
enum class ExposureKind : std::uint8_t { kVirtual, kReal, kRest };
inline constexpr std::array<Term<ExposureKind>, 3> kExposureKinds{{
    {ExposureKind::kVirtual, "virtual", Text::tr("on the simulator"), "counts towards a virtual phase"},
    {ExposureKind::kReal, "real", Text::tr("on the real arm"), "counts towards a real phase"},
    {ExposureKind::kRest, "rest", Text::tr("rest"), "counts towards the rest that an arm allows"},
}};
/// Returns the exposure that a phase of this kind produces.
[[nodiscard]] constexpr ExposureKind exposureIn(PhaseKind phase) noexcept {
  return phase == PhaseKind::kVirtual ? ExposureKind::kVirtual : ExposureKind::kReal;
}

/// Kinds of protocol deviation. Those before kTrainedBeforeScoring are reported by hand.
enum class DeviationKind : std::uint8_t {
  kLate,
  kAbsent,
  kDeviceFailed,
  kSwapped,
  kPhaseCutShort,
  kPhaseTooLong,
  kRestTooLong,
  kOther,
  kTrainedBeforeScoring,
  kTrainedOutsidePlan,
};
inline constexpr std::array<Term<DeviationKind>, 10> kDeviationKinds{{
    {DeviationKind::kLate, "late", Text::tr("late")},
    {DeviationKind::kAbsent, "absent", Text::tr("absent")},
    {DeviationKind::kDeviceFailed, "device failed", Text::tr("device failed")},
    {DeviationKind::kSwapped, "swapped", Text::tr("swapped")},
    {DeviationKind::kPhaseCutShort, "phase cut short", Text::tr("phase cut short")},
    {DeviationKind::kPhaseTooLong, "phase too long", Text::tr("phase too long")},
    {DeviationKind::kRestTooLong, "rest too long", Text::tr("rest too long")},
    {DeviationKind::kOther, "other", Text::tr("other"), "needs a description"},
    {DeviationKind::kTrainedBeforeScoring, "trained before scoring", Text::tr("trained before scoring")},
    {DeviationKind::kTrainedOutsidePlan, "trained outside the plan", Text::tr("trained outside the plan")},
}};

/// State of a person; only active people can be chosen for anything new.
enum class PersonState : std::uint8_t { kActive, kLeft, kErased };
inline constexpr std::array<Term<PersonState>, 3> kPersonStates{{
    {PersonState::kActive, "active", Text::tr("active"), "can be chosen"},
    {PersonState::kLeft, "left", Text::tr("has left"), "keeps the record and is offered nowhere"},
    {PersonState::kErased, "erased", Text::tr("erased"), "the identity is gone for good; marks stay"},
}};

enum class EnrolmentState : std::uint8_t { kEnrolled, kCompleted, kWithdrawn };
inline constexpr std::array<Term<EnrolmentState>, 3> kEnrolmentStates{{
    {EnrolmentState::kEnrolled, "enrolled", Text::tr("enrolled"), "takes part"},
    {EnrolmentState::kCompleted, "completed", Text::tr("completed"), "has gone through all phases"},
    {EnrolmentState::kWithdrawn, "withdrawn", Text::tr("withdrawn"),
     "takes part no more; what was recorded stays"},
}};

/// State of a cohort: draft until the first allocation or training; later changes are made by hand.
enum class CohortState : std::uint8_t { kDraft, kRunning, kClosed, kArchived };
inline constexpr std::array<Term<CohortState>, 4> kCohortStates{{
    {CohortState::kDraft, "draft", Text::tr("draft"), "nobody is allocated and nobody has trained"},
    {CohortState::kRunning, "running", Text::tr("running"), "trains and is scored"},
    {CohortState::kClosed, "closed", Text::tr("closed"),
     "takes nothing new; what was asked for may be finished"},
    {CohortState::kArchived, "archived", Text::tr("archived"),
     "closed, and left out of the lists to choose from"},
}};

/// State of a curriculum version. It only moves forward.
enum class CurriculumState : std::uint8_t { kDraft, kRunning, kClosed };
inline constexpr std::array<Term<CurriculumState>, 3> kCurriculumStates{{
    {CurriculumState::kDraft, "draft", Text::tr("published, not begun"), "nobody trains by it yet"},
    {CurriculumState::kRunning, "running", Text::tr("running"), "cohorts may follow it"},
    {CurriculumState::kClosed, "closed", Text::tr("closed"), "no cohort is given it any more"},
}};

/// A rater's decision about their own mark that differs strongly from the others.
enum class DiscrepancyChoice : std::uint8_t { kKeep, kMove, kThird };
inline constexpr std::array<Term<DiscrepancyChoice>, 3> kDiscrepancyChoices{{
    {DiscrepancyChoice::kKeep, "keep", Text::tr("kept"), "the mark stays"},
    {DiscrepancyChoice::kMove, "move", Text::tr("moved"), "a new version of the mark follows"},
    {DiscrepancyChoice::kThird, "third", Text::tr("adjudicator requested"),
     "somebody else scores the case as well"},
}};

/// Returns the table of an enumeration.
[[nodiscard]] constexpr const auto& termsOf(AttemptMode) noexcept {
  return kAttemptModes;
}
[[nodiscard]] constexpr const auto& termsOf(PhaseKind) noexcept {
  return kPhaseKinds;
}
[[nodiscard]] constexpr const auto& termsOf(ExposureKind) noexcept {
  return kExposureKinds;
}
[[nodiscard]] constexpr const auto& termsOf(DeviationKind) noexcept {
  return kDeviationKinds;
}
[[nodiscard]] constexpr const auto& termsOf(PersonState) noexcept {
  return kPersonStates;
}
[[nodiscard]] constexpr const auto& termsOf(EnrolmentState) noexcept {
  return kEnrolmentStates;
}
[[nodiscard]] constexpr const auto& termsOf(CohortState) noexcept {
  return kCohortStates;
}
[[nodiscard]] constexpr const auto& termsOf(CurriculumState) noexcept {
  return kCurriculumStates;
}
[[nodiscard]] constexpr const auto& termsOf(DiscrepancyChoice) noexcept {
  return kDiscrepancyChoices;
}

/// Returns the stored text of `value`.
template <typename Value>
[[nodiscard]] constexpr std::string_view storedText(Value value) noexcept {
  return termsOf(value)[static_cast<std::size_t>(value)].stored;
}

/// Label of `value`, as people read it.
template <typename Value>
[[nodiscard]] constexpr Phrase labelOf(Value value) noexcept {
  return termsOf(value)[static_cast<std::size_t>(value)].label;
}

/// Finds the value with this stored text; empty if unknown.
template <typename Value>
[[nodiscard]] constexpr std::optional<Value> fromStoredText(std::string_view stored) noexcept {
  for (const Term<Value>& term : termsOf(Value{})) {
    if (term.stored == stored) {
      return term.value;
    }
  }
  return std::nullopt;
}

/// Returns the label of a stored text; a text unknown to this version returns itself.
template <typename Value>
[[nodiscard]] Text labelOfStored(std::string_view stored) {
  const std::optional<Value> known = fromStoredText<Value>(stored);
  return known ? Text(labelOf(*known)) : Text(std::string(stored));
}

}  // namespace torsio
