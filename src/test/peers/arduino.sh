#!/usr/bin/env bash
# Lets the code of two Arduino libraries for the SIM800 use the phone's AT port: arduino.sh FOLDER [PROFILE]
#
# Sources (built here, nothing of them is part of this repository): https://github.com/vshymanskyy/TinyGSM 4c552105 (LGPL),
# https://github.com/adafruit/Adafruit_FONA 22621187 (BSD). The core of Arduino is the stand-in in the folder arduino beside
# this script. Needs git, g++ and python3; FOLDER receives sources and programs, and what is there is used again. The suite is
# built before (mvn -q -Dmaven.test.skip=true package).
#
# Prints a line for each call of the libraries and how many were right; docs/AT.md has the figures. PROFILE is the value of
# --at-profile, sim800 unless it is named; TRACE=1 shows the dialogue.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
source() {
    if [ ! -d "$folder/$2" ]; then
        git clone -q "https://github.com/$1/$2" "$folder/$2"
        git -C "$folder/$2" checkout -q "$3"
    fi
}
source vshymanskyy TinyGSM 4c552105
source adafruit Adafruit_FONA 22621187
build="g++ -std=c++17 -w -O1 -I$here/arduino"
$build -DARDUINO=10800 -I"$folder/TinyGSM/src" "$here/arduino/tinygsm.cc" -o "$folder/tinygsm"
$build -DARDUINO=10800 -I"$folder/Adafruit_FONA" "$folder/Adafruit_FONA/Adafruit_FONA.cpp" "$here/arduino/fona.cc" -o "$folder/fona"
exec python3 "$here/arduino_calls.py" "$folder" "${2:-sim800}"
