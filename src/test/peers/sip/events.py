"""Writes a pcap file of telephone events, RTP type TYPE (RFC 4733): events.py FILE TYPE KEYS"""
import struct
import sys

path, event_type, keys = sys.argv[1], int(sys.argv[2]), sys.argv[3]
packets = []
sequence, timestamp, now = 1, 8000, 0.0
for key in keys:
    code = "0123456789*#ABCD".index(key)
    sent = [(160 * i, 0) for i in range(1, 7)] + [(960, 0x80)] * 3
    for index, (duration, end) in enumerate(sent):
        first = 0x80 if index == 0 else 0
        rtp = struct.pack(">BBHII", 0x80, event_type | first, sequence, timestamp, 0x5135)
        rtp += struct.pack(">BBH", code, end | 10, duration)
        udp = struct.pack(">HHHH", 6000, 6000, 8 + len(rtp), 0) + rtp
        ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), 0, 0, 64, 17, 0, bytes([127, 0, 0, 1]), bytes([127, 0, 0, 1]))
        packets.append((now, b"\0" * 12 + b"\x08\0" + ip + udp))
        sequence += 1
        now += 0 if end else 0.02
    timestamp += 1600
    now += 0.08
with open(path, "wb") as out:
    out.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 1))
    for when, frame in packets:
        out.write(struct.pack("<IIII", int(when), int(when % 1 * 1e6), len(frame), len(frame)) + frame)
