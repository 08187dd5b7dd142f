#!/bin/sh
# What each effect costs a scene, or would cost: rows of the tables in docs/effects.md, and the chart.
# usage, after ./dev build: tests/bench/effects_table.sh CHART.svg [SCENE] [--side N]...
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
chart=$1
shift
"$root/build/release/glimt" bench --suite effects --chart "$chart" "$@" |
  awk 'NR == 1 || NR == 2 || NR == 4 { print; next }
       $11 != "" && $1 != "effects" {
         printf "| `%s` | %.1f %s %s | %s %s %s | %s |\n", $1, 1000 * $5,
                "[" sprintf("%.1f", 1000 * substr($6, 2)), sprintf("%.1f]", 1000 * $7),
                $8, $9, $10, $2 " " $3 " " $4 }'
