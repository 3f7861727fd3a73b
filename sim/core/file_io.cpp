// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/core/file_io.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

#include "sim/core/error.h"
#include "sim/core/file_lock.h"

namespace torsio {

namespace fs = std::filesystem;

void refuseUnwritable(const fs::path& file) {
  throw Error(ErrorCode::kFileUnwritable, Text::tr("cannot be written"), file.string(),
              Text::tr("Check that the folder exists, is not read-only, and that the disk is not full"));
}

namespace {

/// Reads a pipe or a device to its end; calls `endless`, which throws, for more than any input of Torsio.
std::string readStream(std::istream& in, const std::function<void()>& endless) {
  constexpr std::size_t kMost_bytes = 256UL * 1024UL * 1024UL;
  constexpr std::size_t kPiece_bytes = 64UL * 1024UL;
  std::string bytes;
  std::string piece(kPiece_bytes, '\0');
  while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())) || in.gcount() > 0) {
    bytes.append(piece, 0, static_cast<std::size_t>(in.gcount()));
    if (bytes.size() > kMost_bytes) {
      endless();
    }
  }
  return bytes;
}

}  // namespace

std::string readFile(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("no such file"), file.string(), Text::tr("Check the path"));
  }
  const auto refuseFile = [&file](const Text& what) {
    throw Error(ErrorCode::kFileUnreadable, what, file.string(),
                Text::tr("Check that it is a file you may read"));
  };
  std::ifstream in(file, std::ios::binary);
  if (fs::is_directory(file, ignored) || !in) {
    refuseFile(Text::tr("cannot be read"));
  }
  if (!fs::is_regular_file(file, ignored)) {
    return readStream(in, [&] { refuseFile(Text::tr("does not end")); });
  }
  std::ostringstream bytes;
  if (in.peek() != EOF && !(bytes << in.rdbuf())) {
    refuseFile(Text::tr("cannot be read"));
  }
  return bytes.str();
}

void requireNoDatabase(const fs::path& file) {
  if (looksLikeDatabase(file)) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("is a database, which is never overwritten"),
                file.string(), Text::tr("Name another file"));
  }
}

fs::path temporaryBeside(const fs::path& file) {
  fs::path temporary = file;
  temporary += ".part";
  return temporary;
}

void writeFileAtomically(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  PartFile part(file);
  {
    std::ofstream out(part.path(), std::ios::binary | std::ios::trunc);
    if (out) {
      write(out);
      out.close();
    }
    if (!out) {
      refuseUnwritable(file);
    }
  }
  part.finish();
}

void writeFileAtomically(const fs::path& file, std::string_view bytes) {
  writeFileAtomically(file, [bytes](std::ostream& out) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

void ensureFolder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed || !fs::is_directory(folder, failed)) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("folder cannot be created"), folder.string(),
                Text::tr("Choose a folder in which you may write"));
  }
}

}  // namespace torsio

#ifndef _WIN32
#include <sys/resource.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/stat.h>
#endif

namespace torsio {

namespace fs = std::filesystem;

namespace {

bool closeToOthers(const fs::path& file) noexcept {
#ifdef _WIN32
  return file.empty() && false;
#else
  constexpr auto kOthers = fs::perms::group_all | fs::perms::others_all;
  std::error_code failed;
  const fs::file_status status = fs::symlink_status(file, failed);
  const bool ours = fs::is_regular_file(status) || fs::is_directory(status);
  if (failed || !ours || (status.permissions() & kOthers) == fs::perms::none) {
    return false;
  }
  fs::permissions(file, kOthers, fs::perm_options::remove, failed);
  return !failed;
#endif
}

}  // namespace

void keepFilesPrivate() noexcept {
#ifndef _WIN32
  umask(S_IRWXG | S_IRWXO);
#endif
  disableCoreDumps();
}

void disableCoreDumps() noexcept {
#ifndef _WIN32
  const rlimit none{.rlim_cur = 0, .rlim_max = 0};
  setrlimit(RLIMIT_CORE, &none);
#endif
#ifdef __linux__
  prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);  // where dumps go to a program (apport), the limit counts for nothing
#endif
}

bool makePrivate(const fs::path& file) noexcept {
  bool changed = closeToOthers(file);
  std::error_code unreadable;
  if (fs::is_directory(fs::symlink_status(file, unreadable))) {
    for (fs::recursive_directory_iterator entry(file, unreadable), end; !unreadable && entry != end;
         entry.increment(unreadable)) {
      changed = closeToOthers(entry->path()) || changed;
    }
  }
  return changed;
}

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
