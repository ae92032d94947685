#!/usr/bin/env bash
# Lets wvdial dial NUMBER as a data call on a terminal device, once; ends when wvdial has read that there is no carrier.
# Usage: wvdial.sh DEVICE NUMBER
set -u
device=$1 number=$2
settings=$(mktemp)
trap 'rm -f "$settings"' EXIT
printf '[Dialer Defaults]\nModem = %s\nBaud = 115200\nInit1 = ATZ\nPhone = %s\nUsername = a\nPassword = a\nDial Attempts = 1\n' \
    "$device" "$number" > "$settings"
# wvdial 1.61 runs tasks on small stacks of its own. The lazy binding of a symbol saves all vector registers there, overwrote the
# end mark of a stack in 7 of 27 runs on a processor with AVX-512, and wvdial aborted after NO CARRIER; bound at its start, in 0 of 60.
LD_BIND_NOW=1 timeout 30 wvdial --config "$settings" 2>&1 | sed '/^--> No Carrier!/q'
