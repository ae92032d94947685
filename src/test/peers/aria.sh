#!/usr/bin/env bash
# Lets ARIA's own programs drive SimRobot over P2OS: aria.sh FOLDER [WORLD [SECONDS]]
#
# Source (GPL, built here, nothing of it is part of this repository): https://github.com/reedhedges/AriaCoda b0d02e0
# Needs git, g++, make and python3. FOLDER receives source and programs (400 MB); what is there is used again. The suite is
# built before (mvn -q -Dmaven.test.skip=true package).
#
# Prints how long `demo` and `wander` take to be connected to robot and laser and to their first command, and how far wander
# drives; docs/MEASURED.md has the figures. With a display, SimRobot's window shows it: SIMROBOT_WINDOW=1.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
aria=$folder/AriaCoda
if [ ! -d "$aria" ]; then
    git clone -q https://github.com/reedhedges/AriaCoda "$aria"
    git -C "$aria" checkout -q b0d02e0
fi
if [ ! -x "$aria/examples/wander" ] || [ ! -x "$aria/examples/demo" ]; then
    make -C "$aria" -j2 lib/libAria.so examples/wander examples/demo
fi
export ARIA=$aria LD_LIBRARY_PATH=$aria/lib
exec python3 "$here/aria_drive.py" "$aria/examples" "${2:-$here/../../../worlds/office.map}" "${3:-30}"
