#!/usr/bin/env bash
# Installs the peers of `mvn verify -Ppeers` that Debian, PyPI and npm package. Libraries go to target/peers. What cannot be had
# is named at the end; the exit status is 0 then, too, because the tests skip what is not there.
set -euo pipefail
cd "$(dirname "$0")/../../.."

have() { command -v "$1" >/dev/null 2>&1; }

packages=()
have tshark || packages+=(tshark)
have toast || packages+=(libgsm-tools)
have sox || packages+=(sox)
have flite || packages+=(flite)
have espeak-ng || packages+=(espeak-ng)
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
have ofonod || packages+=(ofono)
[ -x /usr/lib/polkit-1/polkitd ] || packages+=(polkitd)
have dbus-daemon || packages+=(dbus-daemon)
have Xvfb || packages+=(xvfb)
have openbox || packages+=(openbox)
have xdotool || packages+=(xdotool)
have pulseaudio || packages+=(pulseaudio)
have parec || packages+=(pulseaudio-utils)
[ -d /usr/share/doc/libasound2-plugins ] || packages+=(libasound2-plugins)
have xwininfo || packages+=(x11-utils)
for program in stp hlr mgw msc bsc; do
    have "osmo-$program" || packages+=("osmo-$program")
done
have osmo-bts-omldummy || packages+=(osmo-bts)
have ip || packages+=(iproute2)
have cc || packages+=(gcc libc6-dev)
have go || packages+=(golang-go)
have curl || packages+=(curl)
have baresip || packages+=(baresip-core)
have linphonec || packages+=(linphone-cli)
have sipp || packages+=(sip-tester)
have tiffinfo || packages+=(libtiff-tools)
have swaks || packages+=(swaks)
have chromium || packages+=(chromium)
have zbarimg || packages+=(zbar-tools)
have python3 || packages+=(python3)
python3 -m pip --version >/dev/null 2>&1 || packages+=(python3-pip)
have npm || packages+=(nodejs npm)
[ -n "$(find /usr/include -maxdepth 2 -name spandsp.h 2>/dev/null)" ] || packages+=(libspandsp-dev)
[ -n "$(find /usr/include -maxdepth 2 -name tiffio.h 2>/dev/null)" ] || packages+=(libtiff-dev)
missing=()
# An archive or a network may be down for a moment.
thrice() { "$@" || { sleep 5; "$@"; } || { sleep 20; "$@"; }; }
apt() { DEBIAN_FRONTEND=noninteractive apt-get -qq -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300 "$@" >/dev/null; }
if [ ${#packages[@]} -gt 0 ]; then
    echo "== installing ${packages[*]}"
    thrice apt update || true
    if ! thrice apt install -y --no-install-recommends "${packages[@]}"; then
        # One that the archive lacks must not keep the others out.
        for package in "${packages[@]}"; do
            apt install -y --no-install-recommends "$package" || missing+=("$package")
        done
    fi
fi

# Versions are those that were tested: a new one is tried on purpose.
mkdir -p target/peers
python_library() {
    [ -d "target/peers/python/$1" ] || thrice python3 -m pip install -q --target target/peers/python "$2" || missing+=("$2")
}
python_library prometheus_client prometheus-client==0.26.0
python_library smpplib smpplib==2.2.4
python_library pycrate_mobile pycrate==0.8.1
python_library roslibpy roslibpy==2.1.0
python_library websockets websockets==17.0
python_library aiosmtpd aiosmtpd==1.4.6
python_library pjsua2 pjsua2-python==2.15.1.post1
python_library gsmmodem python-gsmmodem-new==0.13.0
python_library pocketsphinx pocketsphinx==5.1.1
gsmmodem_tests() {
    local source
    source=$(mktemp -d)
    python3 -m pip download -q --no-deps --no-binary python-gsmmodem-new -d "$source" python-gsmmodem-new==0.13.0 \
        && tar -xzf "$source"/*.tar.gz -C "$source" \
        && cp -r "$source"/python-gsmmodem-new-*/test target/peers/gsmmodem-tests
    local status=$?
    rm -r "$source"
    return $status
}
[ -d target/peers/gsmmodem-tests ] || thrice gsmmodem_tests || missing+=("python-gsmmodem-new's tests")
node_library() {
    [ -d "target/peers/node_modules/$1" ] \
        || thrice npm install --silent --no-fund --no-audit --prefix target/peers "$2" || missing+=("$2")
}
node_library smpp smpp@0.5.1
node_library puppeteer-core puppeteer-core@24.43.0
node_library roslib roslib@2.1.0
node_library roslib-1 roslib-1@npm:roslib@1.4.1
smpp_commands() { (cd src/test/peers/smpp_commands && go build -buildvcs=false -o ../../../../target/peers/smpp_commands .); }
[ -x target/peers/smpp_commands ] || thrice smpp_commands || missing+=("gosmpp and fiorix/go-smpp (Go 1.25)")
if [ ${#missing[@]} -gt 0 ]; then
    echo "peers: could not be installed, so the tests that need them are skipped: ${missing[*]}" >&2
fi
