#!/bin/sh
# Starts volumebench-run with the libraries beside this script. The machine's own libraries are taken
# where a driver may need newer ones than these; what it lacks, or has too old, comes from here:
#   lib/     VTK and what it stands on; no machine without ParaView has these
#   opengl/  libglvnd, which hands OpenGL to the driver: where the machine has none
#   gcc/     libstdc++ and libgcc_s: where the machine's are older
#   glibc/   the C library with its loader: where the machine's is older
set -eu
home=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")" && pwd)
PATH=$PATH:/usr/sbin:/sbin

# Where the machine's loader finds a library.
system_library() {
  ldconfig -p 2>/dev/null | sed -n "s|^[[:space:]]*$1 (.*x86-64.*) => ||p" | head -n 1
}

# Whether version $1 is lower than version $2.
older() {
  [ "$1" != "$2" ] && [ "$(printf '%s\n%s\n' "$1" "$2" | sort -V | head -n 1)" = "$1" ]
}

libraries=$home/lib
if [ -z "$(system_library libOpenGL.so.0)" ] || [ -z "$(system_library libGLX.so.0)" ] ||
  [ -z "$(system_library libEGL.so.1)" ]; then
  libraries=$libraries:$home/opengl
fi
gcc=$(system_library libstdc++.so.6)
if [ -z "$gcc" ] || ! grep -q "$(cat "$home/gcc/version")" "$gcc"; then
  libraries=$libraries:$home/gcc
fi
libraries=$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}

program=$home/bin/volumebench-run
glibc=$(getconf GNU_LIBC_VERSION 2>/dev/null | sed 's/.* //')
if [ -z "$glibc" ] || older "$glibc" "$(cat "$home/glibc/version")"; then
  # The loader's own folders are Debian's; those of other systems are named here.
  exec "$home/glibc/ld-linux-x86-64.so.2" \
    --library-path "$home/glibc:$libraries:/usr/lib64:/lib64" "$program" "$@"
fi
LD_LIBRARY_PATH=$libraries exec "$program" "$@"
