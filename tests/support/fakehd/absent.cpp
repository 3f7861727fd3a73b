// SPDX-License-Identifier: GPL-3.0-or-later
// A library that the vendor's needs but that is not installed: linked against, never found.
extern "C" int fakehd_absent();

int fakehd_absent() {
  return 0;
}
