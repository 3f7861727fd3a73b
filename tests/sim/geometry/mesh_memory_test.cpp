// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh file costs in memory at its peak, whatever bytes of it were
// changed, measured in a process of its own (POSIX).
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/random.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "tests/support/mesh_formats.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

constexpr int kFiles = 400;
constexpr long kMaxGrowth_KiB = 100'000;
constexpr unsigned kPatience_s = 120;

/// Changes up to eight bytes, mostly of the head, to anything or to another
/// digit.
std::string changed(std::string bytes, std::size_t head, Random& random) {
  const auto below = [&](std::size_t most) {
    return std::min(static_cast<std::size_t>(random.uniform() * static_cast<double>(most)), most - 1);
  };
  for (std::size_t n = 0, count = 1 + below(8); n < count; ++n) {
    char& byte = bytes[below(4) == 0 ? below(bytes.size()) : below(head)];
    byte = below(2) == 0 ? static_cast<char>('0' + below(10)) : static_cast<char>(below(256));
  }
  return bytes;
}

/// Reads changed files. Returns whether each was a mesh or was refused.
bool readAll(const fs::path& file, const std::string& sound, int files, std::uint64_t seed) {
  const std::size_t head = std::min<std::size_t>(sound.size(), 1'500);
  Random random(seed);
  for (int i = 0; i < files; ++i) {
    writeFileAtomically(file, changed(sound, head, random));
    try {
      (void)readMesh(file, 0.001);
    } catch (const Error&) {
      continue;
    } catch (...) {
      return false;
    }
  }
  return true;
}

/// Largest memory of a process that reads so many changed files; 0: it did not
/// end as it should.
long peak_KiB(const fs::path& file, const std::string& sound, int files) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(kPatience_s);
    ::_exit(readAll(file, sound, files, 43) ? 0 : 1);
  }
  int state = 0;
  rusage usage{};
  if (::wait4(child, &state, 0, &usage) != child || !WIFEXITED(state) || WEXITSTATUS(state) != 0) {
    return 0;
  }
  return usage.ru_maxrss;
}

TEST(MeshMemory, AChangedFileTakesLittleMoreThanAWholeOne) {
  const TriangleMesh mesh = testing::capsule(0.01, 0.06, 24, 24);
  const fs::path folder = fs::temp_directory_path() / ("torsio-mesh-memory-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  for (const auto& [name, sound] : {std::pair(std::string("a.glb"), testing::glbBytes(mesh)),
                                    std::pair(std::string("a.gltf"), testing::gltfText(mesh))}) {
    const long before_KiB = peak_KiB(folder / name, sound, 0);
    const long peak = peak_KiB(folder / name, sound, kFiles);
    std::cout << "  " << kFiles << " changed files " << name << " of " << sound.size()
              << " bytes: " << (peak - before_KiB) / 1024 << " MiB at the peak\n";
    EXPECT_GT(peak, 0) << name;
    EXPECT_LT(peak - before_KiB, kMaxGrowth_KiB) << name;
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace torsio
