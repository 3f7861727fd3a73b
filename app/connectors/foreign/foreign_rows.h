// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/connectors/foreign/foreign_map.h"
#include "sim/core/vec3.h"

namespace torsio {

/// The numbers of a line, unconverted.
struct ForeignRow {
  std::int64_t time_us = 0;  ///< if the file has times
  Vec3 position;
  std::vector<double> rotation{};  ///< numbersOf() of them, in the file's order
  double grip = 0.0;
  bool gap = false;  ///< a missing pose; no other field is set
};

/// Reads the lines of one file in order.
class ForeignRows {
 public:
  virtual ~ForeignRows() = default;
  /// Fills `row` from line `number` (from 1). Returns false if the line holds no pose (a header, an empty
  /// line, another device). Throws Error{kBadData} with file, line and column.
  virtual bool read(std::string_view line, std::size_t number, ForeignRow& row) = 0;
};

/// Reads the rows of a table that are already cut into cells, in order.
class ForeignCells {
 public:
  virtual ~ForeignCells() = default;
  /// As ForeignRows::read(). The first row is the header, with `number` 0.
  virtual bool readCells(const std::vector<std::string_view>& cells, std::size_t number, ForeignRow& row) = 0;
};

/// The columns of a table that the map names, without repetition.
[[nodiscard]] std::vector<std::string> tableColumns(const ForeignMap& map);
/// The reader of these. `name`: of the file, for messages.
[[nodiscard]] std::unique_ptr<ForeignCells> foreignCells(const ForeignMap& map, const std::string& name);

/// The reader for the map's layout, which is not Parquet (contract). `name`: of the file, for messages.
/// Throws Error{kBadData} if the layout has no such instrument.
[[nodiscard]] std::unique_ptr<ForeignRows> foreignRows(const ForeignMap& map, ForeignLayout layout,
                                                       const std::string& name);

}  // namespace torsio
