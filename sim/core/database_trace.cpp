// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/database_trace.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kPage = 4096;
constexpr std::size_t kHead = 100;         // of the file, at the start of its first page
constexpr std::uintmax_t kMaxPages = 256;  // that are looked at, spread over the file

std::size_t numberAt(std::string_view page, std::size_t at) {
  return static_cast<std::size_t>(static_cast<std::uint8_t>(page[at])) << 8U |
         static_cast<std::uint8_t>(page[at + 1]);
}

/// Whether all that a page's own head says of its cells fits,
/// https://www.sqlite.org/fileformat2.html#b_tree_pages. `begin`: where that head is. An empty page says too
/// little.
bool isPageOfRows(std::string_view page, std::size_t begin) {
  constexpr std::array<char, 4> kKinds{2, 5, 10, 13};  // inner and leaf pages of indices and tables
  constexpr std::size_t kFragmentsAtMost = 60;
  constexpr std::size_t kCellsAtLeast = 2;
  const char kind = page[begin];
  if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end()) {
    return false;
  }
  const std::size_t cells = numberAt(page, begin + 3);
  const std::size_t content = numberAt(page, begin + 5);
  const std::size_t pointers = begin + (kind < 10 ? 12 : 8);
  if (cells < kCellsAtLeast || pointers + 2 * cells > content || content >= kPage ||
      static_cast<std::uint8_t>(page[begin + 7]) > kFragmentsAtMost) {
    return false;
  }
  for (std::size_t i = 0; i < cells; ++i) {
    const std::size_t cell = numberAt(page, pointers + 2 * i);
    if (cell < content || cell >= kPage) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool looksLikeDatabase(const fs::path& file) {
  constexpr std::string_view kFirstWords("SQLite format 3");
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) {
    return false;
  }
  const std::uintmax_t size = fs::file_size(file, failed);
  std::ifstream in(file, std::ios::binary);
  std::string page(kPage, '\0');
  if (failed || !in.read(page.data(), kFirstWords.size())) {
    return false;
  }
  if (page.starts_with(kFirstWords)) {
    return true;
  }
  const std::uintmax_t pages = size / kPage;
  const std::uintmax_t looks = std::min(pages, kMaxPages);
  for (std::uintmax_t look = 0; look < looks; ++look) {
    const std::uintmax_t number = look * pages / looks;
    in.seekg(static_cast<std::streamoff>(number * kPage));
    if (!in.read(page.data(), kPage)) {
      return false;
    }
    if (isPageOfRows(page, number == 0 ? kHead : 0)) {
      return true;
    }
  }
  return false;
}

}  // namespace torsio
