"""Deciphers the bursts of a simgsm-cells --gsmtap capture by libosmogsm and decodes them by libosmocoding.

usage: decipher.py CAPTURE GSMTAP-PORT RSL-PORT

CAPTURE is a pcapng or pcap file of the UDP port and of the TCP port of the Abis, whose ENCRYPTION COMMANDs and CHANNEL ACTIVATIONs
hold the keys. Prints for each ciphered block of a signalling channel that a key makes readable one line, "up|down TIMESLOT FRAME
ALGORITHM BLOCK", and at the end "readable N of BLOCKS without-key M". Blocks of fast associated channels are left out.
"""
import ctypes
import ctypes.util
import glob
import re
import subprocess
import sys

BURSTS = 4
BITS = 114


def library(name):
    found = glob.glob("/usr/lib/*/lib%s.so*" % name) or [ctypes.util.find_library(name)]
    return ctypes.CDLL(found[0])


gsm, coding = library("osmogsm"), library("osmocoding")


def keystream(algorithm, kc, frame, uplink):
    down, up = (ctypes.c_uint8 * BITS)(), (ctypes.c_uint8 * BITS)()
    key = (ctypes.c_uint8 * 16)(*bytes.fromhex(kc))
    if gsm.osmo_a5(algorithm, key, ctypes.c_uint32(frame), down, up):
        raise SystemExit("osmo_a5 refuses algorithm %d" % algorithm)
    return list(up if uplink else down)


def decode(bursts, streams):
    soft = (ctypes.c_int8 * (116 * BURSTS))()
    for i, (bits, stream) in enumerate(zip(bursts, streams)):
        data = list(bits[3:60]) + list(bits[88:145])
        plain = [bit ^ key for bit, key in zip(data, stream)]
        # 57 bits, two stealing flags, 57 bits; the most certain 0 is 127, 1 is -127
        for at, bit in enumerate(plain[:57] + [1, 1] + plain[57:]):
            soft[116 * i + at] = -127 if bit else 127
    block, errors, total = (ctypes.c_uint8 * 23)(), ctypes.c_int(), ctypes.c_int()
    wrong = coding.gsm0503_xcch_decode(block, soft, ctypes.byref(errors), ctypes.byref(total))
    return None if wrong or errors.value else bytes(block)


def fields(capture, *arguments):
    command = ["tshark", "-r", capture, "-T", "fields", *arguments]
    lines = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True, text=True).stdout
    return [line.replace(":", "") for line in lines.split()]


def keys(capture, port):
    """The keys of the Abis: encryption information, length 9, algorithm 2 (A5/1) or 4 (A5/3)."""
    found = {}
    for payload in fields(capture, "-Y", "tcp.srcport==" + port, "-d", "tcp.port==%s,data" % port, "-e", "tcp.payload"):
        for algorithm, kc in re.findall("0709(02|04)([0-9a-f]{16})", payload):
            found[kc] = int(algorithm) - 1
    return found


def blocks(capture, port):
    """Groups of four bursts of one channel and direction, all of whose bits are stolen."""
    bursts = {}
    for packet in fields(capture, "-Y", "!icmp && udp.dstport==" + port, "-d", "udp.port==%s,data" % port, "-e", "udp.payload"):
        packet = bytes.fromhex(packet)
        if packet[2] == 3:
            bursts.setdefault((packet[4] >> 6 & 1, packet[3], packet[5]), []).append(
                (int.from_bytes(packet[8:12], "big"), packet[16:]))
    for (uplink, slot, _), sent in bursts.items():
        at = 0
        while at + BURSTS <= len(sent):
            group = sent[at:at + BURSTS]
            distances = [frame - group[0][0] for frame, _ in group]
            if distances in ([0, 1, 2, 3], [0, 26, 52, 78]) and all(bits[60] and bits[87] for _, bits in group):
                yield uplink, slot, group
                at += BURSTS
            else:
                at += 1


def main(capture, gsmtap, rsl):
    known = keys(capture, rsl)
    total = readable = clear = 0
    for uplink, slot, group in blocks(capture, gsmtap):
        bursts = [bits for _, bits in group]
        total += 1
        clear += decode(bursts, [[0] * BITS] * BURSTS) is not None
        for kc, algorithm in known.items():
            block = decode(bursts, [keystream(algorithm, kc, frame, uplink) for frame, _ in group])
            if block:
                print("up" if uplink else "down", slot, group[0][0], "a5/%d" % algorithm, block.hex())
                readable += 1
                break
    print("readable", readable, "of", total, "without-key", clear)


if __name__ == "__main__":
    main(*sys.argv[1:])
