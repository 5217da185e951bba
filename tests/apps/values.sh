#!/bin/sh
# SPDX-License-Identifier: MIT
# values.sh NAME.mesh: writes a .sol file with one number at each vertex, the vertex's own number.
set -eu
count=$(sed -n '/^Vertices$/{n;p;q;}' "$1")
printf 'MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n%s\n1 1\n' "$count"
seq "$count"
echo End
