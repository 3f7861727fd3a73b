// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstring>
#include <dlfcn.h>
#include <elf.h>
#include <filesystem>
#include <fstream>
#include <link.h>
#include <optional>
#include <string>
#include <vector>

#include "sim/device/hdapi/hdapi_library.h"

namespace torsio {

namespace {

#if defined(__x86_64__)
constexpr ElfW(Half) kThisMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr ElfW(Half) kThisMachine = EM_AARCH64;
#else
constexpr ElfW(Half) kThisMachine = EM_NONE;
#endif

/// Files that a name may mean: itself when it is a path, else the system's usual folders.
std::vector<std::filesystem::path> filesOf(const std::string& name) {
  if (name.find('/') != std::string::npos) {
    return {name};
  }
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"/usr/local/lib", "/usr/lib/x86_64-linux-gnu", "/usr/lib/aarch64-linux-gnu",
                             "/usr/lib64", "/usr/lib"}) {
    files.push_back(std::filesystem::path(folder) / name);
  }
  return files;
}

/// Why the loader could not read this file whole; empty when it can. The loader maps a file as its headers
/// say: a truncated one ends the process (SIGBUS), and one for another processor counts as absent.
std::optional<std::string> flawOfFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return std::strerror(EACCES);
  }
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  ElfW(Ehdr) head{};
  if (failed || !file.read(reinterpret_cast<char*>(&head), sizeof(head)) ||
      std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0) {
    return "it is not a library (no ELF header)";
  }
  if (kThisMachine != EM_NONE && (head.e_machine != kThisMachine || head.e_ident[EI_CLASS] != ELFCLASS64)) {
    return "it was built for another kind of processor (ELF machine " + std::to_string(head.e_machine) + ")";
  }
  file.seekg(static_cast<std::streamoff>(head.e_phoff));
  for (int i = 0; i < head.e_phnum; ++i) {
    ElfW(Phdr) part{};
    if (!file.read(reinterpret_cast<char*>(&part), sizeof(part)) || part.p_offset > size ||
        part.p_filesz > size - part.p_offset) {
      return "the file is truncated";
    }
  }
  return std::nullopt;
}

/// What is wrong with the files that the name matches; empty if there are none, or a sound one.
std::optional<std::string> flawOf(const std::string& name) {
  std::optional<std::string> flaw;
  for (const std::filesystem::path& file : filesOf(name)) {
    std::error_code unreadable;
    if (!std::filesystem::is_regular_file(file, unreadable)) {
      continue;
    }
    const std::optional<std::string> found = flawOfFile(file);
    if (!found) {
      return std::nullopt;
    }
    flaw = file.string() + ": " + *found;
  }
  return flaw;
}

}  // namespace

LoadedLibrary loadLibrary(const std::string& name) {
  LoadedLibrary library;
  if (const std::optional<std::string> flaw = flawOf(name)) {
    library.found = true;
    library.systemText = *flaw;
    return library;
  }
  // Local: libHD exports hundreds of internals and Windows-like names that must not meet ours.
  library.handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library.handle != nullptr) {
    library.found = true;
    return library;
  }
  const char* text = dlerror();
  library.systemText = text != nullptr ? text : "";
  // "FILE: cannot open shared object file: ..." names the file that is missing: ours or one it needs.
  const std::size_t colon = library.systemText.find(": cannot open shared object file");
  const std::string missing = library.systemText.substr(0, colon);
  const bool isMissing = colon != std::string::npos;
  library.found = !isMissing || missing != name;
  if (isMissing && library.found) {
    library.missingDependency = missing;
  }
  return library;
}

void* librarySymbol(void* handle, const char* name) noexcept {
  return dlsym(handle, name);
}

}  // namespace torsio
