#!/usr/bin/env bash
# Writes the files of README.md that Gwyddion makes, into this folder.
# Needs gwyddion, libgwyddion20-dev, libglib2.0-dev and xvfb (Debian 12). GLIB_ROOT is where the
# headers of glib are, where they are not in /.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
root=${GLIB_ROOT:-}
lib=/usr/lib/x86_64-linux-gnu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
includes=(-I/usr/include/gwyddion -I"$lib/gwyddion/include" -I"$root/usr/include/glib-2.0"
  -I"$root$lib/glib-2.0/include")
libraries=(-L"$lib" -lgwyapp2 -lgwydgets2 -lgwydraw2 -lgwymodule2 -lgwyprocess2 -lgwyddion2
  -l:libgobject-2.0.so.0 -l:libglib-2.0.so.0 -l:libgtk-x11-2.0.so.0)
cc -o "$work/make" make_gwyddion_files.c "${includes[@]}" "${libraries[@]}"
HOME=$work LC_ALL=C xvfb-run -a "$work/make" .
