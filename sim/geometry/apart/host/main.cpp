// SPDX-License-Identifier: GPL-3.0-or-later
// torsio-mesh FILE SCALE MEMORY_MB PROCESSOR_S: reads a mesh file for Torsio within limits and leaves it, or
// the refusal, in the file that it was given. Started by Torsio, never by hand.
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "sim/base/error.h"
#include "sim/geometry/apart/mesh_mail.h"
#include "sim/geometry/mesh/mesh_reader.h"

namespace torsio {
namespace {

// A sanitizer reserves more address space than any limit.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif

bool limited(int resource, std::uint64_t most) {
  const rlimit limit{most, most};
  return setrlimit(static_cast<__rlimit_resource>(resource), &limit) == 0;
}

/// Gives up what reading a file does not need; false when the system refuses.
bool bind(std::uint64_t memory_MB, std::uint64_t processor_s) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  return (!kLimitsMemory || limited(RLIMIT_AS, memory_MB * 1'000'000)) && limited(RLIMIT_CPU, processor_s) &&
         limited(RLIMIT_FSIZE, kMostAnswerBytes) && limited(RLIMIT_CORE, 0) && limited(RLIMIT_NPROC, 0);
}

bool leave(const std::string& answer) {
  std::size_t done = 0;
  while (done < answer.size()) {
    const ssize_t written = ::write(kMeshAnswerFile, answer.data() + done, answer.size() - done);
    if (written <= 0) {
      return false;
    }
    done += static_cast<std::size_t>(written);
  }
  return true;
}

Error tooMuchMemory(const std::string& file, const std::string& memory_MB) {
  return {ErrorCode::kFileUnreadable,
          Text::tr("M05 the importer needs more than %1 MB of memory for this file", memory_MB), file,
          Text::tr("Decimate the surface, or export the mesh again")};
}

std::string answerTo(const std::string& file, double scale_m, const std::string& memory_MB) {
  try {
    return mailOf(readMesh(file, scale_m));
  } catch (const Error& error) {
    // assimp catches what the memory refuses, and says so in these words
    const bool memory = error.happened().find("bad_alloc") != std::string::npos;
    return mailOf(memory ? tooMuchMemory(file, memory_MB) : error);
  } catch (const std::bad_alloc&) {
    return mailOf(tooMuchMemory(file, memory_MB));
  } catch (const std::exception& error) {
    return mailOf(Error(ErrorCode::kFileUnreadable,
                        Text::tr("M05 the importer failed on this file: %1", printable(error.what())), file,
                        Text::tr("Export the mesh again")));
  }
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  constexpr int kWords = 5;
  if (argc != kWords ||
      !torsio::bind(std::strtoull(argv[3], nullptr, 10), std::strtoull(argv[4], nullptr, 10))) {
    return EXIT_FAILURE;
  }
  return torsio::leave(torsio::answerTo(argv[1], std::strtod(argv[2], nullptr), argv[3])) ? EXIT_SUCCESS
                                                                                          : EXIT_FAILURE;
}
