#!/bin/sh
# Puts the counts of a report between the two marks of a page, as a Markdown table.
#
#   tests/hostile/table.sh PAGE REPORT
#
# A report holds lines "group, files, pictures, with warnings, refused, otherwise, seconds, MiB" with
# tabs between, as Tally of verdict.h writes them. Rows of one group are added up.
set -eu
if [ $# -ne 2 ]; then
  echo "usage: table.sh PAGE REPORT, the file that GLIMT_HOSTILE_REPORT named" >&2
  exit 2
fi
page=$1
report=$2

table() {
  echo "| Files | Tried | Picture | Picture and warnings | Exit 3 and one line | Otherwise | Longest | Most memory |"
  echo "|---|---:|---:|---:|---:|---:|---:|---:|"
  awk -F '\t' '
  !($1 in known) { known[$1] = 1; groups[++count] = $1 }
  {
    for (i = 2; i <= 6; ++i) { sum[$1, i] += $i; all[i] += $i }
    for (i = 7; i <= 8; ++i) {
      if ($i > most[$1, i]) most[$1, i] = $i
      if ($i > worst[i]) worst[i] = $i
    }
  }
  function row(name, a, b, c, d, e, s, m) {
    printf "| %s | %d | %d | %d | %d | %d | %.1f s | %d MiB |\n", name, a, b, c, d, e, s, m
  }
  END {
    for (g = 1; g <= count; ++g) {
      n = groups[g]
      row(n, sum[n, 2], sum[n, 3], sum[n, 4], sum[n, 5], sum[n, 6], most[n, 7], most[n, 8])
    }
    row("**all**", all[2], all[3], all[4], all[5], all[6], worst[7], worst[8])
  }' "$report"
}

rows=$(table) awk '
/^<!-- counts end/ { inside = 0 }
!inside { print }
/^<!-- counts begin/ { print ENVIRON["rows"]; inside = 1 }
' "$page" >"$page.new"
mv "$page.new" "$page"
