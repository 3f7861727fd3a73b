// SPDX-License-Identifier: GPL-3.0-or-later
// Build tool for the lighting of the scene view: torsio_make_light FILE.
#include <cstdio>
#include <exception>

#include "app/gui/scene/studio_light.h"
#include "sim/core/file_io.h"

int main(int argc, char** argv) {
  constexpr int kPixelsAcross = 256;
  if (argc != 2) {
    std::fputs("usage: torsio_make_light FILE\n", stderr);
    return 2;
  }
  try {
    torsio::writeFileAtomically(argv[1], torsio::gui::studioLightFile(kPixelsAcross));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "torsio_make_light: %s\n", error.what());
    return 1;
  }
  return 0;
}
