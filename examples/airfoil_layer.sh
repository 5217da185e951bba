#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# examples/airfoil_layer.sh COMMAND [OPTIONS...]: meshes a NACA 0012 airfoil with a boundary layer and
# a wake, by a metric written as expressions. COMMAND is the asterism command, OPTIONS are those of
# `asterism mesh`, at least one -o.
set -euo pipefail
command=$1
shift

# The nearest point of the chord line, (c, 0): the line starts at the centre of the nose's circle,
# so that directions away from it are normal to the nose, and goes on downstream as the wake.
c='max(x,0.0159)'
away="((x-$c)^2+y^2)"  # squared distance from that point
# Half the thickness of the airfoil there (nothing in the wake), and the distance from the surface.
s="min($c,1)"
thickness="0.6*(0.2969*sqrt($s)-0.1260*$s-0.3516*$s^2+0.2843*$s^3-0.1036*$s^4)"
gap="max(0,sqrt($away)-$thickness)"
# Lengths wanted across the layer and along it: small at the surface, growing away from it and
# downstream, more and more alike. Along the nose, whose radius is 0.0159, directions turn fast:
# there the layer's triangles must be short.
wake='max(0,x-1)'
surface='min(0.08,0.012+0.4*sqrt(x^2+y^2))'
across="(0.01+0.3*$gap+0.1*$wake)"
along="($surface+0.3*$gap+0.1*$wake)"
# M = I / along^2 + (1 / across^2 - 1 / along^2) n n^T, n the direction away from the chord line; it
# fades where there is none, within 0.01 of the line. Positive definite: across is less than along.
fading="((1/$across^2-1/$along^2)/($away+0.0001))"
m11="1/$along^2+$fading*(x-$c)^2"
m12="$fading*(x-$c)*y"
m22="1/$along^2+$fading*y^2"

exec "$command" mesh airfoil --metric "expr:$m11;$m12;$m22" --size 1 "$@"
