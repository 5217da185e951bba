# SPDX-License-Identifier: MIT
# Sourced by scripts that try something in a bare Debian 12. Needs root and debootstrap.
# ASTERISM_MIRROR names another mirror.

# make_bare_debian FOLDER [PACKAGE...]: makes the smallest system that has these packages.
make_bare_debian() {
  local system=$1 IFS=,
  shift
  set -- ca-certificates "$@"
  debootstrap --variant=minbase --include="$*" bookworm "$system" \
    "${ASTERISM_MIRROR:-http://deb.debian.org/debian}" >"$system.log" 2>&1 || { tail -3 "$system.log" >&2; return 1; }
  rm -f "$system.log"
  chmod 755 "$system"  # mktemp's folders are closed to apt's own user
}

# in_bare_debian FOLDER COMMAND: runs the command by sh, without this system's environment. It has a /proc of its own,
# in which programs like rustc look for where they are.
in_bare_debian() {
  env -i HOME=/root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    DEBIAN_FRONTEND=noninteractive \
    unshare --mount sh -euc 'mount -t proc proc "$1/proc"; exec chroot "$1" sh -euc "$2"' sh "$1" "$2"
}

# size_of_bare_debian FOLDER: prints the number of packages and the size in megabytes.
size_of_bare_debian() {
  echo "$(in_bare_debian "$1" "dpkg-query -W -f '\${db:Status-Status}\n'" | grep -cx installed) packages," \
    "$(in_bare_debian "$1" "apt-get clean" && du -sxm "$1" | cut -f1) MB"
}
