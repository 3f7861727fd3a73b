// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// SQL for a column of a remark's newest revision, or `otherwise` if it was never edited.
[[nodiscard]] inline std::string newestOfRemark(const std::string& remark, const std::string& column,
                                                const std::string& otherwise) {
  return "COALESCE((SELECT r." + column + " FROM remark_revision r WHERE r.remark_id = " + remark +
         ".id ORDER BY r.version DESC LIMIT 1), " + otherwise + ")";
}

}  // namespace torsio
