# SPDX-License-Identifier: MIT
# For bash: empty Debian 12 systems below a folder, to try packages in. Needs root and mmdebstrap.

# make_root ROOT PACKAGE...: a new one with these packages, and no more than apt beside them.
make_root() {
  local root=$1
  shift
  rm -rf "$root"
  mmdebstrap --quiet --variant=apt --dpkgopt=force-unsafe-io --include="$(IFS=,; echo "$*")" bookworm "$root"
}

# in_root ROOT COMMAND: there, with /proc, without this shell's environment.
in_root() {
  env --ignore-environment PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    unshare --mount sh -c 'mount -t proc proc "$1/proc" && exec chroot "$1" sh -c "$2"' in_root "$1" "$2"
}
