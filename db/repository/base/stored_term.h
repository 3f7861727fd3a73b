// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "assessment/domain/study/protocol_terms.h"
#include "db/connection/db_error.h"
#include "db/connection/row_reader.h"

namespace torsio {

/// Throws DbError (kCheck): a column holds a text that matches none of its values.
[[noreturn]] inline void refuseStoredTerm(const std::string& column, const std::string& stored) {
  throw DbError(DbFault::kCheck, "SELECT " + column,
                Text::tr("the column %1 holds \"%2\", which this version does not know", column, stored),
                Text::tr("database"), Text::tr("Update Torsio on this machine, or restore a backup"));
}

/// Returns the stored text of a term; empty: null.
template <typename TermValue>
[[nodiscard]] Value termOrNull(const std::optional<TermValue>& value) {
  return value ? Value(storedText(*value)) : Value();
}

/// Reads a nullable term column. Throws DbError (kCheck) for an unknown text.
template <typename TermValue>
[[nodiscard]] std::optional<TermValue> readMaybeTerm(RowReader& row) {
  const std::optional<std::string> stored = row.maybeText();
  if (!stored) {
    return std::nullopt;
  }
  const std::optional<TermValue> value = fromStoredText<TermValue>(*stored);
  if (!value) {
    refuseStoredTerm(row.lastName(), *stored);
  }
  return value;
}

/// Reads a term column. Throws DbError (kCheck) for null and for an unknown text.
template <typename TermValue>
[[nodiscard]] TermValue readTerm(RowReader& row) {
  const std::optional<TermValue> value = readMaybeTerm<TermValue>(row);
  if (!value) {
    refuseStoredTerm(row.lastName(), "");
  }
  return *value;
}

}  // namespace torsio
