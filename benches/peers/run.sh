#!/bin/bash
# Adds our elements to the tables of the peer kit: PEERS_KIT=folder-of-the-kit ./run.sh
# The kit's own variables (BUILD, CORE, REPS, BASE) are handed on.
set -eu
: "${PEERS_KIT:?set PEERS_KIT to the folder of the peer kit}"
PEERS_KIT=$(cd "$PEERS_KIT" && pwd)
cd "$(dirname "$0")"
TARGET=${CARGO_TARGET_DIR:-$(dirname "$PWD")/target}
RUSTFLAGS="-C target-cpu=native" cargo build --profile peers --quiet --target-dir "$TARGET"
export EXTRA="ours $TARGET/peers/libcontact_peers.so ours_pts_q4 ours_pts_q4_cpp ours_ctc_l2"
exec "$PEERS_KIT/run.sh"
