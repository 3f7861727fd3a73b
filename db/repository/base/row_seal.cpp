// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/row_seal.h"

#include <charconv>
#include <string_view>

namespace torsio {

namespace {
constexpr std::string_view kEntries = R"({"entries":)";
}  // namespace

std::string sealedJson(std::int64_t entries, std::size_t rows) {
  return std::string(kEntries) + std::to_string(entries) + R"(,"rows":)" + std::to_string(rows) + "}";
}

std::int64_t entriesOf(const std::string& sealedJson) {
  std::int64_t entries = 0;
  if (sealedJson.starts_with(kEntries)) {
    std::from_chars(sealedJson.data() + kEntries.size(), sealedJson.data() + sealedJson.size(), entries);
  }
  return entries;
}

}  // namespace torsio
