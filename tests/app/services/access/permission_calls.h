// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "app/services/access/session_context.h"

namespace torsio {

/// One service function and the operation that it must require. Every service is listed here: .ci/rights
/// finds functions that require a right and are not called. Its arguments refer to nothing that exists: with
/// the right, the call returns nothing or reports an unknown object, and no relevant data change. `name`: the
/// function and, after a comma, what is special about this call. `also`: a second operation that also permits
/// it (SessionContext::requireEither()).
struct ServiceCall {
  Operation operation;
  const char* name;
  std::function<void(SessionContext&, const std::filesystem::path& folder)> run;
  std::optional<Operation> also{};
};

/// Id of no object.
inline constexpr const char* kNoSuch = "none";

[[nodiscard]] std::vector<ServiceCall> administratorCalls();  ///< access, people, maintenance
[[nodiscard]] std::vector<ServiceCall> studyCalls();          ///< study
[[nodiscard]] std::vector<ServiceCall> reportingCalls();      ///< reporting
[[nodiscard]] std::vector<ServiceCall> connectorCalls();      ///< mail, learning records, imports
[[nodiscard]] std::vector<ServiceCall> reviewCalls();         ///< review
[[nodiscard]] std::vector<ServiceCall> trainingCalls();       ///< training

}  // namespace torsio
