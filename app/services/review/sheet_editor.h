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

/// Change made by one step of the history.
struct SheetChange {
  enum class Kind { kScore, kCleared, kNotAssessable, kComment, kAllCleared };
  Kind kind = Kind::kScore;
  std::string row{};  ///< code; kOverallRow: the overall mark (also for kComment and kAllCleared)
};

/// Edits a sheet with unlimited undo and redo. Successive keystrokes in one text form one step. A plain value
/// without database or window. One thread.
class SheetEditor {
 public:
  /// `start` may lack rows; rows missing from the rubric are dropped. `withOverall`: false for forms without
  /// an overall mark.
  SheetEditor(RubricRevision rubric, Sheet start, bool withOverall = true);

  [[nodiscard]] const RubricRevision& rubric() const noexcept { return rubric_; }
  /// Contains every row of the rubric, in order.
  [[nodiscard]] const Sheet& sheet() const noexcept { return states_[at_].sheet; }
  /// Returns codes in scoring order: the rubric's rows, then kOverallRow if there is one.
  [[nodiscard]] std::vector<std::string> order() const;
  [[nodiscard]] SheetAnswer answer(const std::string& row) const;
  [[nodiscard]] const ScoreScale& scale(const std::string& row) const;

  /// The functions below return false and change nothing if there is nothing to change or the score is
  /// outside the scale. `merge`: continues the previous keystroke ("1", "0" for ten).
  bool setScore(const std::string& row, std::int64_t score_steps, bool merge = false);
  /// An empty reason clears the answer.
  bool setNotAssessable(const std::string& row, const std::string& reason);
  bool clear(const std::string& row);
  bool clearAll();
  bool setComment(const std::string& comment);

  [[nodiscard]] bool canUndo() const noexcept { return at_ > 0; }
  [[nodiscard]] bool canRedo() const noexcept { return at_ + 1 < states_.size(); }
  /// Return what undo() and redo() would change.
  [[nodiscard]] std::optional<SheetChange> undoable() const;
  [[nodiscard]] std::optional<SheetChange> redoable() const;
  bool undo();
  bool redo();

  /// Call after each save with the draft's revision, which applies to all states of the history.
  void saved(std::int64_t revision);

 private:
  struct State {
    Sheet sheet;
    SheetChange change;  // that led to this state
    bool open = false;   // the next keystroke in the same text joins this step
  };
  bool apply(Sheet next, SheetChange change, bool joins);
  [[nodiscard]] static SheetRow* rowIn(Sheet& sheet, const std::string& code);

  RubricRevision rubric_;
  bool withOverall_;
  std::vector<State> states_;
  std::size_t at_ = 0;
};

/// Interprets a digit on a scale: 7 is seven points; 1 and then 0 is ten; a single 0 is zero, or ten on a
/// scale that starts above zero. `typed`: value of the previous digits in the same row, in points. Empty: not
/// a score on this scale.
[[nodiscard]] std::optional<std::int64_t> stepsForDigit(const ScoreScale& scale, int digit,
                                                        std::optional<std::int64_t> typed_points);
/// Returns the change for an arrow key: half a point, or one step if a point cannot be halved.
[[nodiscard]] std::int64_t arrowSteps(const ScoreScale& scale) noexcept;

}  // namespace torsio
