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

/// Returns a paragraph for the erasure question: the copies that still contain these people, each with the
/// date by which it should be gone; empty: none known. Needs the right to erase.
[[nodiscard]] QString copiesText(SessionContext& session, std::span<const PersonId> people,
                                 const QLocale& locale);

}  // namespace torsio::gui
