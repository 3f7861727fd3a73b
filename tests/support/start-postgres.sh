#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A private PostgreSQL for the tests, in a temporary folder on a free port, listening on this machine only.
#
#   export TORSIO_TEST_POSTGRES=$(tests/support/start-postgres.sh start)   prints its address
#   tests/support/start-postgres.sh stop                                   stops the server of TORSIO_TEST_POSTGRES
#   tests/support/start-postgres.sh down | crash | up                      the same server goes away, and comes back
#   tests/support/start-postgres.sh freeze | thaw                          it takes connections and answers nothing
#
# PostgreSQL refuses to run as root: as root, starts it as the user postgres (created by Debian's package) or nobody.
# Its data are disposable, so it does not wait for the disk. Its certificate is for "localhost" only, not for addresses,
# signed by its own authority (ca.crt in the folder of the cluster).
set -euo pipefail

say() { echo "start-postgres: $*" >&2; }
fail() { say "$*"; exit 1; }

tools_folder() {
  local folder
  for folder in $(ls -d /usr/lib/postgresql/*/bin 2>/dev/null | sort -V -r) "$(dirname "$(command -v initdb || echo /none/x)")"; do
    [ -x "$folder/initdb" ] && [ -x "$folder/pg_ctl" ] && { echo "$folder"; return; }
  done
  fail "PostgreSQL is not installed; run: apt-get install postgresql"
}

# Runs a command as a user other than root.
unprivileged() {
  if [ "$(id -u)" -ne 0 ]; then "$@"
  elif id postgres >/dev/null 2>&1; then runuser -u postgres -- "$@"
  else runuser -u nobody -- "$@"
  fi
}

cluster_folder() { echo "${TMPDIR:-/tmp}/torsio-postgres-$1"; }

# The data lie in memory where there is plenty: each of hundreds of tests makes and removes a hundred tables, which are files.
place_data() {
  local folder=$1 memory
  memory=/dev/shm/$(basename "$folder")
  if [ -w /dev/shm ] && [ "$(df --output=avail -k /dev/shm | tail -n 1)" -gt 4000000 ] &&
    [ "$(awk '/^MemAvailable/ { print $2 }' /proc/meminfo)" -gt 8000000 ] && mkdir "$memory" 2>/dev/null; then
    ln -s "$memory" "$folder/data"
    [ "$(id -u)" -ne 0 ] || chown "$(id -u postgres 2>/dev/null || id -u nobody)" "$memory"
  fi
}
remove() { rm -rf "$(readlink -f "$1/data")" "$1"; }

# Clients may request TLS: a certificate of the cluster's own authority.
make_certificates() {
  local folder=$1
  openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj "/CN=Torsio test authority" \
    -keyout "$folder/ca.key" -out "$folder/ca.crt" 2>/dev/null
  openssl req -newkey rsa:2048 -nodes -subj "/CN=localhost" -keyout "$folder/server.key" -out "$folder/server.csr" 2>/dev/null
  openssl x509 -req -days 2 -in "$folder/server.csr" -CA "$folder/ca.crt" -CAkey "$folder/ca.key" -CAcreateserial \
    -extfile <(echo "subjectAltName=DNS:localhost") -out "$folder/server.crt" 2>/dev/null
  chmod 600 "$folder/server.key" "$folder/ca.key"
}

start() {
  local tools port folder password
  tools=$(tools_folder)
  password=$(od -An -N16 -tx1 /dev/urandom | tr -d ' \n')
  for _ in 1 2 3 4 5; do
    port=$((20000 + RANDOM % 12000))  # below those that Linux gives to clients: one of them could take it while it is down
    folder=$(cluster_folder "$port")
    mkdir "$folder" 2>/dev/null || continue
    (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null && { rmdir "$folder"; continue; }
    echo "$password" > "$folder/password"
    echo "-c listen_addresses=127.0.0.1 -c port=$port -c unix_socket_directories= -c ssl=on -c ssl_cert_file=$folder/server.crt -c ssl_key_file=$folder/server.key -c fsync=off -c full_page_writes=off -c wal_level=minimal -c max_wal_senders=0" > "$folder/options"
    make_certificates "$folder"
    place_data "$folder"
    [ "$(id -u)" -ne 0 ] || chown -R "$(id -u postgres 2>/dev/null || id -u nobody)" "$folder"
    if (cd "$folder" &&
        unprivileged "$tools/initdb" -D "$folder/data" -U torsio --pwfile="$folder/password" -A scram-sha-256 \
          -E UTF8 --locale=C.UTF-8 --no-sync &&
        unprivileged "$tools/pg_ctl" -D "$folder/data" -w -t 60 -l "$folder/log" start \
          -o "$(cat "$folder/options")"
       ) > "$folder/start.log" 2>&1; then
      rm -f "$folder/password"
      echo "postgresql://torsio:$password@127.0.0.1:$port/postgres"
      return
    fi
    cat "$folder/start.log" "$folder/log" >&2 2>/dev/null || true
    remove "$folder"
  done
  fail "no cluster could be started"
}

cluster_of_the_address() {
  local port folder
  port=$(sed -n 's|^postgresql://.*:\([0-9]*\)/.*$|\1|p' <<<"${TORSIO_TEST_POSTGRES:-}")
  [ -n "$port" ] || fail "TORSIO_TEST_POSTGRES names no server"
  folder=$(cluster_folder "$port")
  [ -d "$folder/data" ] || fail "no cluster of ours at port $port"
  echo "$folder"
}

control() {
  local folder=$1
  shift
  (cd "$folder" && unprivileged "$(tools_folder)/pg_ctl" -D "$folder/data" -w "$@") >&2
}

stop() {
  local folder
  folder=$(cluster_of_the_address)
  control "$folder" -m immediate stop
  remove "$folder"
}

down() { control "$(cluster_of_the_address)" -m fast stop; }

crash() { control "$(cluster_of_the_address)" -m immediate stop; }

up() {
  local folder
  folder=$(cluster_of_the_address)
  control "$folder" -t 60 -l "$folder/log" start -o "$(cat "$folder/options")"
}

# signal_all SIGNAL: to the server and its processes
signal_all() {
  local server
  server=$(head -n 1 "$(cluster_of_the_address)/data/postmaster.pid")
  # shellcheck disable=SC2046
  kill "-$1" "$server" $(sed -E 's/[(].*[)]/name/' /proc/[0-9]*/stat 2>/dev/null | awk -v server="$server" '$4 == server { print $1 }')
}
freeze() { signal_all STOP; }
thaw() { signal_all CONT; }

case "${1:-}" in
  start) start ;;
  stop | down | crash | up | freeze | thaw) "$1" ;;
  *) fail "say start, stop, down, crash, up, freeze or thaw" ;;
esac
