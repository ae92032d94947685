#!/usr/bin/env python3
"""Lets libosmogsm (by ctypes) and tshark decode frequency lists, and libosmogsm encode them.

    frequency_lists.py <LISTS

Reads lines HEX ARFCN,ARFCN...: 16 octets and what they mean. Prints for each HEX2 LIST LIST: libosmogsm's encoding of the ARFCNs in
a range format (- if it has none), how libosmogsm decodes HEX, and how tshark does.
"""
import ctypes
import glob
import re
import struct
import subprocess
import sys
import tempfile

library = ctypes.CDLL(sorted(glob.glob("/usr/lib/*/libosmogsm.so.*"))[0])
ENCODERS = {127: (library.osmo_gsm48_range_enc_128, 28), 255: (library.osmo_gsm48_range_enc_256, 21),
            511: (library.osmo_gsm48_range_enc_512, 17), 1023: (library.osmo_gsm48_range_enc_1024, 16)}


def encoded(arfcns):
    """As osmo-bsc calls the library, but without the first frequency where the format has a field for it."""
    count = len(arfcns)
    if count < 2:
        return "-"
    numbers = (ctypes.c_int * count)(*arfcns)
    first = ctypes.c_int()
    size = library.osmo_gsm48_range_enc_determine_range(numbers, count, ctypes.byref(first))
    if size not in ENCODERS:
        return "-"
    encoder, room = ENCODERS[size]
    origin = 0 if size == 1023 else first.value
    has_first = ctypes.c_int()
    left = library.osmo_gsm48_range_enc_filter_arfcns(numbers, count, origin, ctypes.byref(has_first))
    if left > room:
        return "-"
    words = (ctypes.c_int * 32)()
    library.osmo_gsm48_range_enc_arfcns(size, numbers, left, words, 0)
    octets = (ctypes.c_uint8 * 16)()
    if size == 1023:
        encoder(octets, origin, has_first.value, words)
    else:
        encoder(octets, origin, words)
    return bytes(octets).hex()


def decoded(octets):
    frequencies = (ctypes.c_uint8 * 1024)()
    library.gsm48_decode_freq_list(frequencies, octets, 16, 0xCE, 1)
    return [arfcn for arfcn in range(1024) if frequencies[arfcn] & 1]


def packet(octets):
    """SYSTEM INFORMATION TYPE 2ter as GSMTAP in UDP in IPv4."""
    message = bytes([2, 4, 1, 0]) + struct.pack(">HbbIBBBB", 1, -60, 0, 0, 1, 0, 0, 0) + bytes.fromhex("490603") + octets
    message += bytes.fromhex("2b2b2b2b")
    datagram = struct.pack(">HHHH", 40000, 4729, 8 + len(message), 0) + message
    return struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(datagram), 0, 0, 64, 17, 0, b"\x7f\0\0\1", b"\x7f\0\0\1") + datagram


def dissected(lists):
    with tempfile.NamedTemporaryFile(suffix=".pcap") as capture:
        capture.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 228))
        for octets in lists:
            data = packet(octets)
            capture.write(struct.pack("<IIII", 0, 0, len(data), len(data)) + data)
        capture.flush()
        text = subprocess.run(["tshark", "-V", "-r", capture.name], capture_output=True, text=True, check=True).stdout
    return [[int(arfcn) for arfcn in line.split()] for line in re.findall("List of ARFCNs =([ 0-9]*)", text)]


lines = [line.split() for line in sys.stdin]
lists = [bytes.fromhex(line[0]) for line in lines]
for line, octets, shown in zip(lines, lists, dissected(lists)):
    arfcns = [int(arfcn) for arfcn in line[1].split(",")]
    print(encoded(arfcns), ",".join(map(str, decoded(octets))), ",".join(map(str, sorted(shown))))
