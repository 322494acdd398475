#!/bin/sh
# Instructions of one evaluation of some elements, by callgrind: a measure that load does not disturb.
#
#   benches/instructions/run.sh [LIBRARY [INCLUDE]]
#
# LIBRARY: libcontact_elements.a, by default that of `cargo build --release -p contact-elements-capi`. Two builds are
# compared by two runs. CFLAGS is handed to the compiler.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
library=${1:-$root/target/release/libcontact_elements.a}
include=${2:-$root/contact-elements/include}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${CC:-cc}" -std=c99 -O2 ${CFLAGS:-} -I"$include" "$root/benches/instructions/instructions.c" "$library" -lm -o "$folder/instructions"
count() {
  "$folder/instructions" "$1" "$2" > "$folder/said"
  valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect=counted \
    "$folder/instructions" "$1" "$2" 2> "$folder/counts" > /dev/null
  sed -n 's/.*Collected : *//p' "$folder/counts"
}
printf '| element | R | R and K |\n|---|---:|---:|\n'
for element in $("$folder/instructions"); do
  printf '| `%s` | %s | %s |\n' "$element" "$(count "$element" residual)" "$(count "$element" tangent)"
done
