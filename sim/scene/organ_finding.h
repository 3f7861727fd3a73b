// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "sim/core/error.h"
#include "sim/core/text.h"

namespace torsio {

/// How heavy a finding about an organ's surface weighs.
enum class FindingWeight {
  kNote,     ///< left out or repaired, the organ is unaffected
  kWarning,  ///< the organ is usable, its numbers are less certain
  kRefusal,  ///< no organ
};

/// Something found about a surface that is to become an organ.
struct OrganFinding {
  std::string code;  ///< of the rule, "M11"; docs/organs.md lists them
  FindingWeight weight = FindingWeight::kWarning;
  Text what;                    ///< one sentence without a full stop, without the code
  Text where;                   ///< place on the organ, or the file
  std::optional<double> value;  ///< measured, in the unit that `what` names
  Text remedy;                  ///< one imperative sentence
};

/// What a scene, a recording and a report keep of a warning.
struct OrganWarning {
  std::string code;
  Text text;  ///< as OrganFinding::what
  friend bool operator==(const OrganWarning&, const OrganWarning&) = default;
};

/// Says a warning with its code: "M20 the organ is 1.7 times as long as wide".
[[nodiscard]] Text coded(const OrganWarning& warning);

/// Makes a finding of a refusal whose sentence begins with the code of a rule; where it has none,
/// "M05" for a file that cannot be read, else "M00".
[[nodiscard]] OrganFinding findingOf(const Error& refusal);

/// Makes the Error{kBadMesh} of a refusal; `file` names the organ.
[[nodiscard]] Error refusalOf(const OrganFinding& finding, const std::string& file);

}  // namespace torsio
