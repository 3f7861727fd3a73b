# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by what tries Torsio on a Debian 12 with nothing installed (.ci/bare, .ci/package), after app/setup.sh. Needs
# root, room under TMPDIR and a mirror: the one that this machine's apt uses, or TORSIO_BARE_MIRROR. What is mounted lives in
# a mount namespace of its own and goes with it, however this ends.

# own_mounts SCRIPT [ARGUMENT...]: starts the script again in a mount namespace of its own.
own_mounts() {
  [ "$(id -u)" -eq 0 ] || fail "run it as root: it makes a chroot"
  if [ -z "${TORSIO_BARE_NAMESPACE:-}" ]; then
    ensure_packages debootstrap git
    exec env TORSIO_BARE_NAMESPACE=1 unshare --mount --propagation private "$@"
  fi
}

leave_bare() {
  local mounted process
  for process in /proc/[0-9]*; do  # what still runs in there, a server of the tests for example
    [ "$(readlink "$process/root" 2>/dev/null)" != "$bare" ] || kill -KILL "${process#/proc/}" 2>/dev/null || true
  done
  for mounted in "$bare/dev" "$bare/proc" "$bare/sys"; do umount --recursive --lazy "$mounted" 2>/dev/null || true; done
  rm -rf --one-file-system "$bare"
}

# make_bare: a fresh Debian 12 in $bare, which goes when the script ends.
make_bare() {
  local mirror
  bare=$(mktemp -d "${TMPDIR:-/tmp}/torsio-bare.XXXXXX")
  chmod 755 "$bare"  # it becomes the root folder, which others than root must be able to enter
  trap leave_bare EXIT
  trap 'exit 130' INT TERM HUP
  mirror=${TORSIO_BARE_MIRROR:-$(apt-get indextargets --format '$(CODENAME) $(REPO_URI)' 'Created-By: Packages' |
    awk '$1 == "bookworm" { print $2; exit }')}
  say "making a bare Debian 12 in $bare"
  debootstrap --variant=minbase bookworm "$bare" ${mirror:+"$mirror"} >"$bare.log" 2>&1 ||
    { tail -n 15 "$bare.log" >&2; fail "debootstrap failed (whole log: $bare.log)"; }
  rm -f "$bare.log"
  cp /etc/resolv.conf /etc/hosts "$bare/etc/"
  mount -t proc proc "$bare/proc"
  mount -t sysfs -o ro sysfs "$bare/sys"
  mount --rbind /dev "$bare/dev"
}

# in_bare COMMAND [ARGUMENT...]: as on a new machine, without the variables of this one. In the background, so that a signal ends it.
in_bare() {
  env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
    chroot "$bare" "$@" &
  wait $!
}
