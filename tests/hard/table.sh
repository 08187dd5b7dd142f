#!/bin/sh
# Turns reports of the hard cases into a Markdown table: one row per case, one column per driver.
#
#   tests/hard/table.sh REPORT... > docs/hard-cases.md
#
# A report holds lines "group, case, what, bound, measured, driver" with tabs between, as checkAtMost
# of hard_case.h writes them. A figure above its bound, or not finite, is bold and marked "(fails)";
# of several figures of one case on one driver the worst stands, so that a later run hides no failure.
# What is known of cases that fail stands in notes.md, which ends the page.
set -eu
if [ $# -eq 0 ]; then
  echo "usage: table.sh REPORT..., the files that GLIMT_HARD_REPORT named" >&2
  exit 2
fi

awk -F '\t' '
# Some awks read "nan" and "inf" as 0, so that a comparison alone would let them pass.
function finite(text) { return text ~ /^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$/ }
function fails(measured, bound) { return !finite(measured) || measured + 0 > bound + 0 }
function worse(candidate, held) {
  if (!finite(held)) return 0
  return !finite(candidate) || candidate + 0 > held + 0
}
NF != 6 {
  printf "%s:%d: not a row of six fields; remove the line or run the cases again\n", FILENAME, FNR > "/dev/stderr"
  broken = 1
  exit
}
{
  row = $1 FS $2 FS $3 FS $4
  if (!(row in known)) { known[row] = 1; rows[++rowCount] = row }
  if (!($6 in seen)) { seen[$6] = 1; drivers[++driverCount] = $6 }
  cell = row SUBSEP $6
  if (!(cell in figure) || worse($5, figure[cell])) figure[cell] = $5
}
END {
  if (broken) exit 1
  print "# Hard cases\n"
  print "Written by tests/hard/table.sh from reports of the hard cases. A figure has to be at most its"
  print "bound; one that is not is bold and marked. softpipe and zink are slow: some of their cases have"
  print "smaller pictures, and rows of their own with wider bounds. Any other dash: the case did not run there"
  print "(softpipe is an interpreter, and takes more than a quarter of an hour for layers and rough glass)."
  if ("nvidia" in seen)
    print "nvidia is an H200 through EGL, with the same binaries; ./dev hard runs the others."
  print ""
  printf "| Group | Case | Measured | Bound |"
  for (d = 1; d <= driverCount; ++d) printf " %s |", drivers[d]
  printf "\n|---|---|---|---:|"
  for (d = 1; d <= driverCount; ++d) printf "---:|"
  print ""
  for (r = 1; r <= rowCount; ++r) {
    split(rows[r], field, FS)
    printf "| %s | %s | %s | %s |", field[1], field[2], field[3], field[4]
    for (d = 1; d <= driverCount; ++d) {
      cell = rows[r] SUBSEP drivers[d]
      if (!(cell in figure)) printf " – |"
      else if (fails(figure[cell], field[4])) { printf " **%s** (fails) |", figure[cell]; ++failed }
      else printf " %s |", figure[cell]
    }
    print ""
  }
  printf "\n%d cases, %d figures above their bound.\n", rowCount, failed
}' "$@"

cat "$(dirname "$0")/notes.md"
