// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/rating/sheet_check.h"

namespace torsio {

/// What one step of the history changed.
struct SheetChange {
  enum class Kind { kScore, kCleared, kNotAssessable, kComment, kAllCleared };
  Kind kind = Kind::kScore;
  std::string row{};  ///< code; kOverallRow: the overall mark (and for kComment, kAllCleared)
};

/// A sheet while it is filled in, with undo and redo from the first mark to the last. Successive keystrokes
/// in one text are one step. Plain value: no database, no window. One thread.
class SheetEditor {
 public:
  /// `start` may lack rows; rows that the rubric does not have are left out. `withOverall`: false for forms
  /// of rows alone.
  SheetEditor(RubricRevision rubric, Sheet start, bool withOverall = true);

  [[nodiscard]] const RubricRevision& rubric() const noexcept { return rubric_; }
  /// With every row of the rubric, in its order.
  [[nodiscard]] const Sheet& sheet() const noexcept { return states_[at_].sheet; }
  /// Codes in the order of scoring: the rubric's rows, then kOverallRow if there is one.
  [[nodiscard]] std::vector<std::string> order() const;
  [[nodiscard]] SheetAnswer answer(const std::string& row) const;
  [[nodiscard]] const ScoreScale& scale(const std::string& row) const;

  /// All return false, changing nothing, when there is nothing to change or the score lies outside the scale.
  /// `merge`: part of the keystroke before ("1", "0" for ten).
  bool setScore(const std::string& row, std::int64_t score_steps, bool merge = false);
  /// An empty reason clears the answer.
  bool setNotAssessable(const std::string& row, const std::string& reason);
  bool clear(const std::string& row);
  bool clearAll();
  bool setComment(const std::string& comment);

  [[nodiscard]] bool canUndo() const noexcept { return at_ > 0; }
  [[nodiscard]] bool canRedo() const noexcept { return at_ + 1 < states_.size(); }
  /// What undo() would take back, redo() would bring again.
  [[nodiscard]] std::optional<SheetChange> undoable() const;
  [[nodiscard]] std::optional<SheetChange> redoable() const;
  bool undo();
  bool redo();

  /// After each save: the revision of the draft, the same for all states of the history.
  void saved(std::int64_t revision);

 private:
  struct State {
    Sheet sheet;
    SheetChange change;  // that led here
    bool open = false;   // the next keystroke of the same text joins
  };
  bool apply(Sheet next, SheetChange change, bool joins);
  [[nodiscard]] static SheetRow* rowIn(Sheet& sheet, const std::string& code);

  RubricRevision rubric_;
  bool withOverall_;
  std::vector<State> states_;
  std::size_t at_ = 0;
};

/// What a digit means on a scale: 7 is seven points; 1 and then 0 is ten; a lone 0 is zero, or ten on a scale
/// that begins above zero. `typed`: what the digits before in the same row have come to, in points. Empty: no
/// score on this scale.
[[nodiscard]] std::optional<std::int64_t> stepsForDigit(const ScoreScale& scale, int digit,
                                                        std::optional<std::int64_t> typed_points);
/// One press of an arrow: half a point, or one step where a point cannot be halved.
[[nodiscard]] std::int64_t arrowSteps(const ScoreScale& scale) noexcept;

}  // namespace torsio
