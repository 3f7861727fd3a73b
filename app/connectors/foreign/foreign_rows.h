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

/// The numbers of one line, as the file has them.
struct ForeignRow {
  std::int64_t time_us = 0;  ///< where the file has times
  Vec3 position;
  std::vector<double> rotation{};  ///< numbersOf() the form, in the order of the file
  double grip = 0.0;
  bool gap = false;  ///< the line stands for a pose that is missing; nothing else is filled in
};

/// Reads the lines of one file in their order. One a file and layout.
class ForeignRows {
 public:
  virtual ~ForeignRows() = default;
  /// Fills `row` from a line, which is `number` (from 1) of the file; false: the line holds no pose (a
  /// header, an empty line, another device). Throws Error{kBadData} that names file, line and column.
  virtual bool read(std::string_view line, std::size_t number, ForeignRow& row) = 0;
};

/// The reader of a layout. `name`: of the file, for messages. Throws Error{kBadData} for an instrument that
/// the layout does not have.
[[nodiscard]] std::unique_ptr<ForeignRows> foreignRows(const ForeignMap& map, ForeignLayout layout,
                                                       const std::string& name);

}  // namespace torsio
