#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# wine.sh <prefix> <program> [argument ...]: runs a Windows program of this build under Wine, in a
# Wine folder of its own, which the first call makes.
set -eu
export WINEPREFIX="$1" WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml,winemenubuilder.exe="
export LC_ALL=C.UTF-8  # or file names are cut down to ASCII
shift
wine=$(command -v wine64 || command -v /usr/lib/wine/wine64 || command -v wine) || {
  echo "wine64 is not installed: Windows programs cannot run here" >&2
  exit 127
}
if [ ! -e "$WINEPREFIX.made" ]; then
  exec 9>"$WINEPREFIX.lock"
  flock 9
  [ -e "$WINEPREFIX.made" ] || "$wine" wineboot --init >/dev/null 2>&1 9>&-
  touch "$WINEPREFIX.made"
  exec 9>&-
fi
exec "$wine" "$@"
