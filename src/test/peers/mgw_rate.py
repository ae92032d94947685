#!/usr/bin/env python3
"""CPU of osmo-mgw for an RTP packet: CALLS calls of two connections each, 50 packets of A-law a second both ways.

usage: mgw_rate.py CALLS SECONDS [osmo-mgw]

Prints packets sent and received, and the processor time of osmo-mgw for each packet that it passed on, from /proc.
"""
import os
import re
import select
import socket
import struct
import subprocess
import sys
import tempfile
import time

calls, seconds = int(sys.argv[1]), int(sys.argv[2])
program = sys.argv[3] if len(sys.argv) > 3 else "osmo-mgw"
control = 22427
config = tempfile.NamedTemporaryFile("w", suffix=".cfg")
config.write(f"""mgcp
 bind ip 127.0.0.1
 bind port {control}
 rtp net-range 40000 {40000 + 4 * calls + 100}
 rtp net-bind-ip 127.0.0.1
 number endpoints {calls + 1}
 rtcp-omit
 no rtp keep-alive
""")
config.flush()
mgw = subprocess.Popen([program, "-s", "-c", config.name], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
mgcp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
mgcp.settimeout(2)
mgcp.connect(("127.0.0.1", control))


def crcx(transaction, call, endpoint, own):
    text = (f"CRCX {transaction} {endpoint}@mgw MGCP 1.0\r\nC: {call:x}\r\nL: p:20, a:PCMA\r\nM: sendrecv\r\n\r\n"
            f"v=0\r\nc=IN IP4 127.0.0.1\r\nm=audio {own} RTP/AVP 8\r\na=ptime:20\r\n")
    for _ in range(10):
        try:
            mgcp.send(text.encode())
            answer = mgcp.recv(4096).decode()
            break
        except OSError:
            time.sleep(0.3)
    else:
        sys.exit("osmo-mgw does not answer")
    if not answer.startswith("200"):
        sys.exit("CRCX: " + answer)
    return answer


def cpu_seconds():
    fields = open(f"/proc/{mgw.pid}/stat").read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


try:
    ends = []
    for call in range(calls):
        endpoint = "rtpbridge/*"
        for leg in range(2):
            end = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            end.bind(("127.0.0.1", 0))
            end.setblocking(False)
            answer = crcx(2 * call + leg + 1, call + 1, endpoint, end.getsockname()[1])
            named = re.search(r"Z: (\S+)@", answer)
            endpoint = named.group(1) if named else endpoint
            end.connect(("127.0.0.1", int(re.search(r"m=audio (\d+)", answer).group(1))))
            ends.append(end)
    poller = select.epoll()
    by_number = {end.fileno(): end for end in ends}
    for end in ends:
        poller.register(end, select.EPOLLIN)

    def receive(wait):
        ready = poller.poll(max(0, wait))
        for number, _ in ready:
            by_number[number].recv(2048)
        return len(ready)

    sent = heard = 0
    before = cpu_seconds()
    start = time.monotonic()
    for sequence in range(50 * seconds):
        for i, end in enumerate(ends):
            due = start + sequence * 0.02 + 0.02 * i / len(ends)
            if i % 32 == 0:
                heard += receive(0)
            while due - time.monotonic() > 0.001:
                heard += receive(due - time.monotonic())
            end.send(struct.pack(">BBHII", 0x80, 8, sequence & 0xFFFF, sequence * 160, i) + b"\xd5" * 160)
            sent += 1
    end_of_last = time.monotonic() + 1
    while time.monotonic() < end_of_last:
        heard += receive(0.1)
    spent = cpu_seconds() - before
    print(f"{calls} calls, {sent / (time.monotonic() - start - 1):.0f} packets a second: {sent} sent, {heard} received,"
          f" {spent / max(1, heard) * 1e6:.1f} microseconds of CPU each")
finally:
    mgw.terminate()
