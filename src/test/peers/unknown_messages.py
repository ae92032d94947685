"""A controller that sends messages made by pycrate to a phone over one tower of simgsm-cells.

usage: unknown_messages.py COUNT SEED

Prints "port N", where the tower connects (--center). Each message is of a random class of mobility management, call control or radio
resources, as pycrate fills it, half of them with a changed octet. IDENTITY REQUEST follows each: its answer shows that the phone lives.
Answers in between are the phone's answers to the message. Messages that end or move the connection are left out. RSL messages
that no base station receives are mixed in; each has to be answered by ERROR REPORT. Prints at the end
"sent N unknown U answered A rsl R reported E"; U counts types that the suite does not know, each of which has to be answered."""
import collections
import random
import select
import socket
import sys

from pycrate_mobile.TS24008_CC import CCTypeMTClasses
from pycrate_mobile.TS24008_MM import MMTypeClasses
from pycrate_mobile.TS44018_RR import RRTypeMTClasses

SDCCH = 0x41
FILL = b"\x2b"
SYSTEM_INFORMATION_3 = bytes.fromhex("49061b1b3900f1100001c90305234e45e50400292b2b2b")
# Downlink types that the suite knows; an answer to them depends on what they say.
KNOWN = {
    5: {0x02, 0x04, 0x11, 0x12, 0x18, 0x1a, 0x21, 0x22, 0x29, 0x31, 0x32},
    6: {0x0d, 0x10, 0x12, 0x13, 0x2b, 0x2d, 0x2e, 0x35},
    3: {0x01, 0x02, 0x03, 0x05, 0x07, 0x0f, 0x19, 0x1a, 0x1d, 0x1e, 0x25, 0x2a, 0x2d, 0x32, 0x34, 0x36, 0x37, 0x3a, 0x3d},
}
# Accept and reject of the update, reject of the card, abort; release and move of the channel; and the probe.
ENDING = {5: {0x02, 0x04, 0x11, 0x18, 0x29}, 6: {0x0d, 0x10, 0x2b, 0x2e}}
CLASSES = {3: CCTypeMTClasses, 5: MMTypeClasses, 6: RRTypeMTClasses}
PROBE = bytes.fromhex("051801")


class Tower:
    def __init__(self, connection):
        self.connection = connection
        self.waiting = b""

    def send(self, stream, payload):
        self.connection.sendall(len(payload).to_bytes(2, "big") + bytes([stream]) + payload)

    def rsl(self, hexadecimal):
        self.send(0, bytes.fromhex(hexadecimal))

    def layer3(self, message):
        self.send(0, bytes([3, 1, 1, SDCCH, 2, 0, 0x0b]) + len(message).to_bytes(2, "big") + message)

    def receive(self, seconds):
        """The next RSL message but measurements; None after that time."""
        while True:
            while len(self.waiting) > 2 and len(self.waiting) >= 3 + int.from_bytes(self.waiting[:2], "big"):
                end = 3 + int.from_bytes(self.waiting[:2], "big")
                stream, payload, self.waiting = self.waiting[2], self.waiting[3:end], self.waiting[end:]
                if stream == 0xfe and payload[0] == 0:
                    self.send(0xfe, b"\x01")
                elif stream == 0 and payload[1] != 0x28:
                    return payload
            if not select.select([self.connection], [], [], seconds)[0]:
                return None
            octets = self.connection.recv(65536)
            if not octets:
                raise SystemExit("the tower has gone")
            self.waiting += octets

    def await_type(self, kind):
        while True:
            message = self.receive(60)
            if message is None:
                raise SystemExit("no RSL message 0x%02x" % kind)
            if message[1] == kind:
                return message

    def access(self):
        """Grants the phone's next access."""
        request = self.await_type(0x13)
        reference = request[5:8].hex()
        self.rsl("082e01%02x" % SDCCH)
        self.await_type(0x33)
        self.rsl("082101%02x030006040003" "0100" % SDCCH)
        self.await_type(0x22)
        grant = bytes.fromhex("2d063f03%02x4064%s0000" % (SDCCH, reference))
        self.send(0, bytes.fromhex("0c1601902b17") + grant + FILL * (23 - len(grant)))
        self.await_type(0x06)


def made(source):
    while True:
        discriminator = source.choice(list(CLASSES))
        kind = source.choice(list(CLASSES[discriminator]))
        if kind in ENDING.get(discriminator, ()):
            continue
        try:
            octets = bytearray(CLASSES[discriminator][kind]().to_bytes())
        except Exception:  # some of pycrate's classes have no default value
            continue
        if len(octets) > 2 and source.random() < 0.5:
            octets[source.randrange(2, len(octets))] = source.randrange(256)
        if len(octets) >= 2 and octets[0] & 0x0f == discriminator and octets[1] & 0x3f not in ENDING.get(discriminator, ()):
            return discriminator, octets[1] & (0xff if discriminator == 6 else 0x3f), bytes(octets[:200])


def main(count, seed):
    source = random.Random(seed)
    server = socket.create_server(("127.0.0.1", 0))
    print("port", server.getsockname()[1], flush=True)
    tower = Tower(server.accept()[0])
    block = SYSTEM_INFORMATION_3.hex()
    tower.rsl("0c1101801e032717" + block)
    tower.access()
    totals = collections.Counter()
    silent = []
    while totals["sent"] < count:
        discriminator, kind, octets = made(source)
        unknown = kind not in KNOWN[discriminator]
        with_rsl = source.random() < 0.1
        tower.layer3(octets)
        if with_rsl:
            tower.rsl("08%02x01%02x" % (source.choice([0x22, 0x23, 0x2a, 0x3b, 0x7e]), SDCCH))
        tower.layer3(PROBE)
        answers = reports = 0
        while True:
            message = tower.receive(5)
            if message is None or message[1] in (0x09, 0x24):
                # the phone has left the channel, as after T3210
                totals["accesses"] += 1
                tower.access()
                answers = None
                break
            if message[1] == 0x1c:
                reports += 1
            elif message[1] == 0x02:
                layer3 = message[9:]
                if layer3[0] == 5 and layer3[1] & 0x3f == 0x19:
                    break
                answers += 1
        if answers is None:
            continue
        totals["sent"] += 1
        totals["unknown"] += unknown
        totals["answered"] += unknown and answers > 0
        totals["rsl"] += with_rsl
        totals["reported"] += with_rsl and reports > 0
        if unknown and not answers:
            silent.append(octets.hex())
    for octets in silent[:20]:
        print("silent", octets)
    print(*(word for name in ("sent", "unknown", "answered", "rsl", "reported") for word in (name, totals[name])))


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]))
