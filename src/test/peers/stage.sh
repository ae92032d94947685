#!/usr/bin/env bash
# Measures Stage with the wander rule and a world of WanderBench: stage.sh FOLDER FILE.map ROBOTS SECONDS
#
# Source (GPL, built here, nothing of it is part of this repository): https://github.com/rtv/Stage 281ed73 (4.3.0)
# Needs git, cmake, g++, libfltk1.3-dev, libglu1-mesa-dev, libjpeg-dev, libpng-dev, libltdl-dev and python3.
# Prints the CPU seconds of a run of 1 s and of one of SECONDS; docs/MEASURED.md has the figures.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
stage=$folder/Stage
if [ ! -d "$stage" ]; then
    git clone -q https://github.com/rtv/Stage "$stage"
    git -C "$stage" checkout -q 281ed73
fi
if [ ! -e "$stage/b/libstage/libstage.so" ]; then
    cmake -S "$stage" -B "$stage/b" -DCMAKE_BUILD_TYPE=Release -DCMAKE_POLICY_VERSION_MINIMUM=3.5
    make -C "$stage/b" -j2 stage
fi
g++ -O2 -w -std=c++11 -I"$stage/libstage" -I"$stage/b" -I"$stage/replace" "$here/stage_wander.cc" -o "$folder/stage_wander" \
    -L"$stage/b/libstage" -lstage -lfltk -lfltk_gl -lGL -lGLU -lltdl
cp "$stage"/worlds/*.inc "$folder"
python3 "$here/stage_world.py" "$2" > "$folder/wander.world"
export LD_LIBRARY_PATH=$stage/b/libstage STAGEPATH=$stage/worlds:$stage/assets
cd "$folder"
for seconds in 1 "$4"; do
    ./stage_wander wander.world "$3" "$seconds" 2>/dev/null | grep '^ran\|ran robots' | sed 's/.*ran/ran/'
done
