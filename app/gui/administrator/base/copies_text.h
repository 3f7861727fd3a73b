// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <QLocale>
#include <QString>

#include "assessment/domain/ids.h"

namespace torsio {
class SessionContext;
}

namespace torsio::gui {

/// The places that still hold people whom somebody is about to erase, each with the day by which it should
/// be gone, as a paragraph to be put below the question; empty: none is known. Needs the right to erase.
[[nodiscard]] QString copiesText(SessionContext& session, std::span<const PersonId> people,
                                 const QLocale& locale);

}  // namespace torsio::gui
