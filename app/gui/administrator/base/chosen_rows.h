// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"

namespace torsio::gui {

/// Returns the elements of `all` whose `idOf(one)` is selected in a list, in the order of `all`. The pointers
/// are valid as long as `all`.
template <typename One, typename IdOf>
[[nodiscard]] std::vector<const One*> chosenRows(const DataTable& table, const std::vector<One>& all,
                                                 IdOf idOf) {
  const QStringList ids = table.selectedIds();
  std::vector<const One*> chosen;
  for (const One& one : all) {
    if (ids.contains(toQString(idOf(one)))) {
      chosen.push_back(&one);
    }
  }
  return chosen;
}

/// Returns `nameOf(one)` of each selected row.
template <typename One, typename NameOf>
[[nodiscard]] QStringList namesOf(const std::vector<const One*>& chosen, NameOf nameOf) {
  QStringList names;
  for (const One* one : chosen) {
    names << toQString(nameOf(*one));
  }
  return names;
}

}  // namespace torsio::gui
