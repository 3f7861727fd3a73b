// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "app/outputs/wording/wording.h"
#include "app/services/review/case_remarks.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/review_queue.h"
#include "app/web/router.h"
#include "app/web/web_sessions.h"

namespace torsio::web {

// JSON between pages and services. Blinded: contains no trial, assignment, person, group or stage; cases are
// identified by the session's handles.

/// Returns "open", "draft" or "submitted".
[[nodiscard]] const char* stateName(SheetState state);
[[nodiscard]] nlohmann::json queueJson(const ReviewQueue& queue, WebSession& session);
[[nodiscard]] nlohmann::json sheetJson(const Sheet& sheet);
/// Shipped rubrics in the page's language, the centre's own as written.
[[nodiscard]] nlohmann::json rubricJson(const RubricRevision& rubric, const Wording& wording);
[[nodiscard]] nlohmann::json checkJson(const SheetCheck& check);
[[nodiscard]] nlohmann::json watchedJson(const WatchLog& watched);
[[nodiscard]] nlohmann::json remarksJson(const std::vector<CaseRemark>& remarks);
[[nodiscard]] nlohmann::json versionsJson(const std::vector<SheetVersion>& versions);
[[nodiscard]] nlohmann::json taskJson(const BlindedTask& task);

/// Parses a sheet. Throws Error{kBadParameter} for an unknown or duplicate row.
[[nodiscard]] Sheet sheetOf(const JsonBody& body, const RubricRevision& rubric);
[[nodiscard]] std::vector<PlayedStretch> playedOf(const JsonBody& body);

}  // namespace torsio::web
