#!/bin/sh
# Turns a report of the shader functions' errors into docs/numerics.md.
#
#   tests/shader/numerics_table.sh REPORT > docs/numerics.md
#
# A report holds lines "family, function, inputs, count, unit, worst, 99.9 percentile, bound, what the
# bound is made of" with tabs between, as checkErrors of error_row.h writes them.
set -eu
if [ $# -ne 1 ]; then
  echo "usage: numerics_table.sh REPORT, the file that GLIMT_NUMERICS_REPORT named" >&2
  exit 2
fi

cat <<'END'
# Rounding errors

Written by `./dev numerics`. The pure files of `shaders/` compile as C++ in single precision, as a
device computes, and in double precision, the yardstick: each row is the difference of the two over
that many inputs, a part of them made to be awkward. 2^-24, one rounding, is half of the last bit of
a float in [1, 2). The record's rows are what comes back against what went in.

A bound is the sum of roundings in the last column, each at its worst and all in the same direction:
standard forward error analysis to the first order (Higham 2002, "Accuracy and Stability of Numerical
Algorithms", chapters 2 and 3). That of intersection is worked out in
`tests/shader/numerics_triangle_test.cpp`. None is fitted to what is measured. A figure above its bound
is bold, and the test fails.

- t: distance of the hit. L: longest edge. c: double area of the triangle seen along the ray, in
  squares of L. Small c is a sliver, or a ray that grazes. Rays are left out where the bound would let a
  weight be off by more than 0.015: the first order says little there.
- Error scale: `errorScale` of `ray_origin.glsl`, the triangle's largest coordinate or more. A ray
  starts 16 of that unit off its triangle, and would have to err by 16 to start on the other side.
- Devices round in the same places but may fuse multiplications and additions, and have sines, cosines
  and roots of their own; `tests/gpu` compares them with the C++ build of single precision.
- Walking the tree is not a pure function and has no row; its hits are compared with Embree's in
  `tests/gpu`.

END
awk -F '\t' '
function finite(text) { return text ~ /^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$/ }
NF != 9 {
  printf "%s:%d: not a row of nine fields; run the tests again\n", FILENAME, FNR > "/dev/stderr"
  broken = 1
  exit
}
NR == 1 {
  print "| | function | inputs | how many | unit | worst | 99.9% below | bound | made of |"
  print "|---|---|---|---:|---|---:|---:|---:|---|"
}
{
  worst = $6
  if (!finite(worst) || worst + 0 > $8 + 0) { worst = "**" worst "** (fails)"; ++failed }
  printf "| %s | %s | %s | %.1e | %s | %s | %s | %s | %s |\n", $1, $2, $3, $4, $5, worst, $7, $8, $9
}
END {
  if (broken) exit 1
  printf "\n%d rows, %d above their bound.\n", NR, failed
}' "$1"
