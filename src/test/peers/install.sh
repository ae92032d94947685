#!/usr/bin/env bash
# Installs the peers of `mvn verify -Ppeers` that Debian, PyPI and npm package. Libraries go to target/peers.
set -euo pipefail
cd "$(dirname "$0")/../../.."

have() { command -v "$1" >/dev/null 2>&1; }

packages=()
have tshark || packages+=(tshark)
have toast || packages+=(libgsm-tools)
have sox || packages+=(sox)
have multimon-ng || packages+=(multimon-ng)
have lame || packages+=(lame)
have opusenc || packages+=(opus-tools)
for sounds in core-sounds-en-wav core-sounds-es-wav core-sounds-fr-wav prompt-es-co moh-opsound-wav; do
    [ -d "/usr/share/doc/asterisk-$sounds" ] || packages+=("asterisk-$sounds")
done
have socat || packages+=(socat)
have bearerbox || packages+=(kannel)
have gammu || packages+=(gammu)
have smsd || packages+=(smstools)
have ModemManager || packages+=(modemmanager)
have wvdial || packages+=(wvdial)
[ -x /usr/lib/polkit-1/polkitd ] || packages+=(polkitd)
have dbus-daemon || packages+=(dbus-daemon)
have Xvfb || packages+=(xvfb)
have openbox || packages+=(openbox)
have xdotool || packages+=(xdotool)
have xwininfo || packages+=(x11-utils)
for program in stp hlr mgw msc bsc; do
    have "osmo-$program" || packages+=("osmo-$program")
done
have osmo-bts-omldummy || packages+=(osmo-bts)
have ip || packages+=(iproute2)
have cc || packages+=(gcc libc6-dev)
have python3 || packages+=(python3)
python3 -m pip --version >/dev/null 2>&1 || packages+=(python3-pip)
have npm || packages+=(nodejs npm)
[ -n "$(find /usr/include -maxdepth 2 -name spandsp.h 2>/dev/null)" ] || packages+=(libspandsp-dev)
if [ ${#packages[@]} -gt 0 ]; then
    echo "== installing ${packages[*]}"
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${packages[@]}" >/dev/null
fi

mkdir -p target/peers
[ -d target/peers/python/prometheus_client ] || python3 -m pip install -q --target target/peers/python prometheus-client
[ -d target/peers/python/smpplib ] || python3 -m pip install -q --target target/peers/python smpplib
[ -d target/peers/python/gsmmodem ] || python3 -m pip install -q --target target/peers/python python-gsmmodem-new
if [ ! -d target/peers/gsmmodem-tests ]; then
    source=$(mktemp -d)
    python3 -m pip download -q --no-deps --no-binary :all: -d "$source" python-gsmmodem-new==0.13.0
    tar -xzf "$source"/*.tar.gz -C "$source"
    cp -r "$source"/python-gsmmodem-new-*/test target/peers/gsmmodem-tests
    rm -r "$source"
fi
[ -d target/peers/node_modules/smpp ] || npm install --silent --no-fund --no-audit --prefix target/peers smpp
