# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the checks of .ci: the compile commands of the release build for another compiler, and the share of a check
# that a commit takes.
source app/setup.sh

lint="$root/build/lint"

# share_of N: a number from 0 to N-1 that the commit chooses, so that N commits look at everything.
share_of() { echo $((16#$(git rev-parse HEAD 2>/dev/null | tail -c 5 || echo 0) % $1)); }

# plain_commands: writes $lint/compile_commands.json, the commands of build/release without precompiled headers (only GCC
# reads those), and $lint/units: one line per compiled unit with the file given to the compiler and those of our sources in
# it that no earlier line has.
plain_commands() {
  [ -f "$build/compile_commands.json" ] || fail "nothing is configured yet: run tests/run first"
  mkdir -p "$lint/passed"
  sed -E 's# -Winvalid-pch -include [^ ]*cmake_pch\.hxx##; s# --param=ggc[^ ]*##g' "$build/compile_commands.json" >"$lint/compile_commands.json"
  sed -nE 's#^ *"file": "([^"]*)",?$#\1#p' "$lint/compile_commands.json" | awk -v root="$root/" -v build="$build/" '
    function add(source) {
      if (index(source, root) != 1 || index(source, build) == 1 || source in seen) return
      seen[source]
      sources = sources " " substr(source, length(root) + 1)
    }
    {
      sources = ""
      if (/\/unity_[0-9]+_cxx[.]cxx$/) {
        while ((getline line < $0) > 0) if (sub(/^#include "/, "", line) && sub(/".*/, "", line)) add(line)
        close($0)
      } else {
        add($0)
      }
      if (sources != "") print $0 sources
    }' >"$lint/units"
}

# command_of FOLDER: compiler and flags of the first unit with a source in FOLDER, else below it, without input and output.
command_of() {
  local unit
  unit=$({ grep -m 1 -E " $1/[^/ ]+( |\$)" "$lint/units" || grep -m 1 -F " $1/" "$lint/units"; } | cut -d ' ' -f 1)
  [ -n "$unit" ] || return 1
  sed -nE 's#^ *"command": "(.*)",?$#\1#p' "$lint/compile_commands.json" | grep -m 1 -F -- " -c $unit" |
    sed -E 's#^[^ ]*ccache ##; s# -o [^ ]* -c .*$##; s#\\"#"#g; s#\\\\#\\#g'
}
