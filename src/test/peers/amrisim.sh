#!/usr/bin/env bash
# Drives AMRISim, MobileSim's successor, by telephone orders: amrisim.sh FOLDER [MODEL]
#
# Sources (GPL, built here, nothing of them is part of this repository):
#   https://github.com/reedhedges/AriaCoda  b0d02e0   libAria
#   https://github.com/reedhedges/AMRISim   26e07b9   AMRISim, with its own copy of libstage
# Needs git, g++, make, autotools, libgtk2.0-dev, python3 and a display (AMRISim opens a window even where it draws none).
# FOLDER receives sources and programs (600 MB); what is there is used again. The suite is built before
# (mvn -q -Dmaven.test.skip=true package). MODEL is AMRISim's: p3dx-no-error (default), p3dx-sh, p3dx ...
#
# Measured with it: 20 orders from 1 cm to 5 m and 1 to 360 degrees; docs/MEASURED.md has the figures.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
model=${2:-p3dx-no-error}
here=$(cd "$(dirname "$0")" && pwd)

source_of() { # NAME COMMIT
    [ -d "$folder/$1" ] && return
    git clone -q "https://github.com/reedhedges/$1" "$folder/$1"
    git -C "$folder/$1" checkout -q "$2"
}

source_of AriaCoda b0d02e0
source_of AMRISim 26e07b9
[ -e "$folder/AriaCoda/lib/libAria.so" ] || make -C "$folder/AriaCoda" -j2
if [ ! -x "$folder/AMRISim/AMRISim" ]; then
    # does not compile as it is: an average is divided by an undeclared i, where the measured interval r is meant
    sed -i 's|( (s/i) \* 0.20 )|( (s/r) * 0.20 )|' "$folder/AMRISim/stage/src/gui.c"
    export AMRISIM_INCLUDE_ROS1=no ARIA="$folder/AriaCoda"
    # its configure step runs twice in parallel and fails, so one job at a time
    make -C "$folder/AMRISim" stage/Makefile
    make -C "$folder/AMRISim"
fi
exec python3 "$here/amrisim_orders.py" "$folder/AMRISim" "$model"
