#!/usr/bin/env bash
# Lets wvdial dial NUMBER as a data call on a terminal device, once. Usage: wvdial.sh DEVICE NUMBER
set -u
device=$1 number=$2
settings=$(mktemp)
trap 'rm -f "$settings"' EXIT
printf '[Dialer Defaults]\nModem = %s\nBaud = 115200\nInit1 = ATZ\nPhone = %s\nUsername = a\nPassword = a\nDial Attempts = 1\n' \
    "$device" "$number" > "$settings"
timeout 30 wvdial --config "$settings" 2>&1
