// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "assessment/domain/rating/instrument.h"

namespace torsio {

/// A trainee's scores, and how another system knows the person.
struct GradedPerson {
  std::string code{};
  std::string name{};                 ///< empty: not stored
  std::string email{};                ///< empty: not stored
  std::string number{};               ///< staff or student number; empty: not stored
  std::vector<std::string> scores{};  ///< points, one per occasion; empty: none that may be shown
};

/// Scores for a learning system. Every score belongs to an occasion of one cohort.
struct Grades {
  std::string title{};                   ///< of the cohort
  std::vector<std::string> occasions{};  ///< in their order
  ScoreScale scale{};
  std::vector<GradedPerson> people{};
};

/// Learning system whose file is written.
enum class GradebookForm {
  kMoodle,  ///< CSV; the columns are assigned during the import
  kCanvas,  ///< CSV with the columns of Canvas's own gradebook export
  kIlias,   ///< the status file of one exercise, which ILIAS wrote and its extension reads back
};
/// Returns the form named "moodle", "canvas" or "ilias". Throws Error{kBadParameter}.
[[nodiscard]] GradebookForm gradebookForm(const std::string& name);
[[nodiscard]] const char* nameOf(GradebookForm form);

/// Returns the text of a file for Moodle or Canvas: a line per person, a column per occasion. Somebody
/// without a staff number goes by the code.
[[nodiscard]] std::string moodleGrades(const Grades& grades);
[[nodiscard]] std::string canvasGrades(const Grades& grades);

/// A status file of ILIAS with marks, and who went without.
struct IliasGrades {
  std::string text{};
  std::vector<std::string> strangers{};  ///< logins of the file that belong to no trainee
  std::vector<std::string> absent{};     ///< codes of trainees with a score who are not in the file
};

/// Returns `status`, the status file of an ILIAS exercise (.csv), with the marks of one occasion: a person is
/// found by the login, which equals the staff number, the mail address (or its part before the @) or the
/// code. Other lines stay as they are. `name`: of the file, for messages. Throws Error{kBadData} for other
/// columns, a login that fits several people, and if nobody is found.
[[nodiscard]] IliasGrades iliasGrades(const Grades& grades, std::size_t occasion, const std::string& status,
                                      const std::string& name);

}  // namespace torsio
