# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by app/run and tests/run: packages, configuration, build. Everything it says goes to standard error.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$root/build/release"

# What Torsio is built from and what it loads when it runs (Debian 12 names).
torsio_packages=(
  g++ cmake ninja-build pkg-config
  qt6-base-dev qt6-tools-dev qt6-l10n-tools libqt6opengl6-dev qt6-charts-dev qt6-svg-dev qt6-declarative-dev qt6-quick3d-dev qt6-shadertools-dev
  qml6-module-qtquick qml6-module-qtqml qml6-module-qtqml-workerscript qml6-module-qtquick-window qml6-module-quick3d
  libqt6sql6-sqlite libqt6sql6-psql libsqlite3-dev libgl1-mesa-dri libglx-mesa0 fonts-noto-core fonts-noto-cjk fonts-dejavu-core
  libeigen3-dev libfcl-dev libassimp-dev zlib1g-dev libboost-dev
  libdcmtk-dev # CT series: plain, deflated, RLE, JPEG lossless, JPEG-LS
  libsdl2-dev libspnav-dev
  libopenigtlink-dev # trackers on the real arm, and Slicer
  libxlsxwriter-dev libreadstat-dev libmicrohttpd-dev
  libcurl4-gnutls-dev ca-certificates # mail, and the answers of time stamp authorities
  libqpdf-dev # tags and outline of the report
  libqrencode-dev # the link on an invitation card, for a phone
  libgnutls28-dev # the certificate that a review desk signs for itself; libmicrohttpd encrypts by it
  libssl-dev # time stamps of the audit trail
  libsodium-dev libzstd-dev nlohmann-json3-dev libcli11-dev
  qt6-websockets-dev libgtest-dev libgmock-dev libbenchmark-dev
)

say() { printf 'torsio: %s\n' "$*" >&2; }
fail() { say "$*"; exit 1; }

# ensure_packages NAME...: installs what is missing in one apt call, as root or through sudo.
ensure_packages() {
  local missing=() name
  local installed
  installed=" $(dpkg-query -W -f='${binary:Package} ${db:Status-Status}\n' 2>/dev/null |
    awk '$2 == "installed" { sub(/:.*/, "", $1); print $1 }' | tr '\n' ' ') "
  for name in "$@"; do
    case "$installed" in *" $name "*) ;; *) missing+=("$name") ;; esac
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  command -v apt-get >/dev/null || fail "these packages are missing and apt-get is not here: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "run as root, or install first: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${#missing[@]} missing packages: ${missing[*]}"
  local log
  log=$(mktemp)
  { "${as_root[@]}" apt-get update &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } \
    >"$log" 2>&1 || { tail -n 15 "$log" >&2; fail "the packages could not be installed (whole log: $log)"; }
  rm -f "$log"
}

# show_progress: reads what ninja says, passes all of it on, and tells on standard error how far it is: in one line that
# is written over and over on a terminal, in a line every fifteen seconds elsewhere. Silent where nothing is built.
show_progress() {
  local line told=0 done_steps=0 all_steps=0 overwrite=0
  if [ -t 2 ]; then overwrite=1; fi
  while IFS= read -r line; do
    printf '%s\n' "$line"
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\] && $line != *'Re-checking globbed'* ]] || continue
    done_steps=${BASH_REMATCH[1]} all_steps=${BASH_REMATCH[2]}
    if ((overwrite)); then
      printf '\rtorsio: building %d of %d\033[K' "$done_steps" "$all_steps" >&2
    elif ((EPOCHSECONDS - told >= 15)); then
      say "building $done_steps of $all_steps"
      told=$EPOCHSECONDS
    fi
  done
  if ((overwrite && all_steps)); then printf '\r\033[K' >&2; fi
  if ((all_steps && done_steps == all_steps)); then say "built"; fi
}

# build_targets TARGET...: configures when needed and builds; the log is shown only when it fails.
build_targets() {
  mkdir -p "$build" 2>/dev/null && [ -w "$build" ] ||
    fail "$build is not writable: it was built by another user; run with sudo, or remove it"
  local log="$build/build.log" cores
  cores=$(nproc 2>/dev/null || echo 2)
  if [ ! -f "$build/build.ninja" ]; then
    say "configuring"
    (cd "$root" && cmake --preset release) >"$log" 2>&1 || { tail -n 25 "$log" >&2; fail "configuration failed (whole log: $log)"; }
    say "building; the README says how long the first time takes (log: $log)"
  fi
  NINJA_STATUS='[%f/%t] ' ninja -C "$build" -j "$cores" "$@" 2>&1 | show_progress >"$log" || {
    grep -n -A 12 -E 'FAILED|error:' "$log" | head -n 60 >&2
    fail "the build failed (whole log: $log)"
  }
}
