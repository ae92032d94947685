#!/usr/bin/env python3
"""Plays seeded sequences of measurement results to a base station controller and prints its handover decisions.

    handover_decisions.py HOST PORT SEED COUNT SITE:ARFCN:BSIC...

Speaks RSL for all towers and for one mobile, whose call has a traffic channel in each tower in turn. For each sequence one line:
sequence=N report=R target=ARFCN/BSIC, or sequence=N none. The same arguments give the same sequences, so that the lines of two
controllers can be compared. A ping after each result makes sure that the controller has decided before the next one.
"""
import random
import select
import socket
import struct
import sys
import time

CALLED = "001010005550200"
# A subscriber can call again when the controller has forgotten its last connection, 2 s after the end.
CALLERS = ["0010100055501%02d" % number for number in range(12)]
# Traffic channels of a tower that may be in use when a call begins; a released one stays so for 2 s.
MOST_ACTIVE = 3


class Tower:
    def __init__(self, host, port, site, arfcn, bsic):
        self.site, self.arfcn, self.bsic = site, arfcn, bsic
        self.socket = socket.create_connection((host, port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.octets, self.messages, self.pongs, self.active = b"", [], 0, set()

    def send(self, stream, payload):
        self.socket.sendall(struct.pack(">HB", len(payload), stream) + payload)

    def traffic_channels(self):
        return sum(channel < "10" for channel in self.active)

    def up(self, text):
        self.send(0, bytes.fromhex(text))

    def layer3(self, channel, text, kind="0302", sapi="00"):
        self.up(kind + "01" + channel + "02" + sapi + "0b%04x" % (len(text) // 2) + text)

    def read(self):
        arrived = self.socket.recv(65536)
        if not arrived:
            raise SystemExit("the controller has closed the link of site %d" % self.site)
        self.octets += arrived
        while len(self.octets) >= 3:
            length, stream = struct.unpack(">HB", self.octets[:3])
            if len(self.octets) < 3 + length:
                break
            payload, self.octets = self.octets[3:3 + length], self.octets[3 + length:]
            if stream == 0xFE:
                self.control(payload)
            elif stream == 0:
                self.answer(payload)

    def control(self, payload):
        if payload[0] == 4:
            name = "site%d arfcn=%d bsic=%d lac=1 cell=%d tch=6" % (self.site, self.arfcn, self.bsic, self.site)
            tags = b""
            for tag, text in ((8, "%d/0/0" % self.site), (1, name)):
                value = bytes([tag]) + text.encode() + b"\0"
                tags += struct.pack(">H", len(value)) + value
            self.send(0xFE, b"\x05" + tags)
            self.send(0xFE, b"\x06")
        elif payload[0] == 0:
            self.send(0xFE, b"\x01")
        elif payload[0] == 1:
            self.pongs += 1

    def answer(self, payload):
        self.messages.append(payload)
        kind, channel = payload[:2], payload[3:4].hex()
        if kind == b"\x08\x21":
            self.active.add(channel)
            self.up("082201" + channel + "080000")
        elif kind == b"\x08\x2e":
            self.active.discard(channel)
            self.up("083301" + channel)
        elif kind == b"\x7e\x70":
            self.up("7e7101" + channel + "f80001f57f000001f34e20")
        elif kind == b"\x7e\x73":
            self.up("7e7401" + channel + "f80001")
        elif kind == b"\x02\x07":
            self.up("0208" + payload[2:6].hex())


class Network:
    def __init__(self, host, port, cells):
        self.towers = [Tower(host, port, *cell) for cell in cells]

    def read(self, seconds):
        for ready in select.select([tower.socket for tower in self.towers], [], [], seconds)[0]:
            next(tower for tower in self.towers if tower.socket is ready).read()

    def wait(self, tower, matches, what, seconds=60):
        end = time.monotonic() + seconds
        while True:
            for message in tower.messages:
                if matches(message):
                    tower.messages.remove(message)
                    return message
            if time.monotonic() > end:
                raise SystemExit("site %d: no %s; %s" % (tower.site, what, [m.hex() for m in tower.messages]))
            self.read(0.1)

    def settle(self):
        """Everything that the controller sends for what it has received has arrived."""
        for tower in self.towers:
            tower.pongs = 0
            tower.send(0xFE, b"\x00")
            while tower.pongs == 0:
                self.read(0.1)

    def downlink(self, tower, channel, prefix):
        found = self.wait(
            tower,
            lambda m: m[0] == 3 and m[3:4].hex() == channel and m[9:].hex().startswith(prefix),
            "layer 3 " + prefix)
        return found[9:].hex()

    def access(self, tower, request, first):
        tower.messages.clear()
        tower.up("0c13018813" + request + "12341100")
        grant = self.wait(tower, lambda m: m[:2] == b"\x0c\x16", "immediate assignment")
        if grant[8] != 0x3F:
            raise SystemExit("site %d: no channel" % tower.site)
        channel = grant[10:11].hex()
        tower.layer3(channel, first, "0206")
        return channel

    def register(self, tower, imsi):
        """Returns the TMSI, or None after a refusal."""
        channel = self.access(tower, "05", "05087000f110fffe33" + identity(imsi))
        sequence = 1
        while True:
            message = self.wait(tower, lambda m: m[0] == 3 and m[3:4].hex() == channel, "location updating")[9:].hex()
            if message.startswith("0518"):
                tower.layer3(channel, "0559" + equipment(imsi))
                sequence ^= 1
            elif message.startswith("0502"):
                tower.layer3(channel, "055b" if sequence else "051b")
                self.downlink(tower, channel, "060d")
                tower.up("020901" + channel + "0200")
                return message[-8:]
            else:
                return None

    def register_at_last(self, tower, imsi):
        """The exchange may not be connected to the controller yet."""
        for _ in range(60):
            temporary = self.register(tower, imsi)
            if temporary:
                return temporary
            time.sleep(1)
        raise SystemExit("location updating is refused")

    def call(self, tower, tmsi):
        """From the channel request to the traffic channel."""
        while max(other.traffic_channels() for other in self.towers) > MOST_ACTIVE:
            self.read(0.1)
        channel = self.access(tower, "e1", "0524710333198105f4" + tmsi)
        self.downlink(tower, channel, "0521")
        tower.layer3(channel, "034504066004020005815e0581550502f0")
        command = self.downlink(tower, channel, "062e")
        traffic = command[4:6]
        tower.up("020601" + traffic + "0200")
        tower.layer3(traffic, "062900")
        # The old channel is released when the assignment is over; a decision before that is not made.
        self.wait(tower, lambda m: m[:2] == b"\x08\x25" and m[3:4].hex() == channel, "end of the assignment")
        self.settle()
        return traffic

    def hang_up(self, tower, channel):
        tower.layer3(channel, "032502e090")
        self.downlink(tower, channel, "832d")
        tower.layer3(channel, "036a")
        self.downlink(tower, channel, "060d")
        tower.up("020901" + channel + "0200")

    def decision(self, tower, channel, results):
        """Plays a sequence. Returns the index of the result that leads to a handover, the tower and the channel there; or None."""
        for index, result in enumerate(results):
            tower.up("082801" + channel + result)
            self.settle()
            for other in self.towers:
                for message in other.messages:
                    # CHANNEL ACTIVATION, activation type 2: handover to another cell.
                    if message[:2] == b"\x08\x21" and message[4:6] == b"\x03\x02":
                        other.messages.remove(message)
                        return index, other, self.hand_over(tower, channel, other, message[3:4].hex())
        return None

    def hand_over(self, tower, channel, other, target):
        """Follows the command into the other cell."""
        self.downlink(tower, channel, "062b")
        other.up("082701" + target + "1100")
        other.up("020601" + target + "0200")
        other.layer3(target, "062c00")
        self.settle()
        return target


def equipment(imsi):
    """An IMEI with its check digit, as the identity of a mobile."""
    digits = "35209900" + imsi[-6:]
    luhn = sum(sum(divmod(int(digit) * (1 + place % 2), 10)) for place, digit in enumerate(digits))
    return identity(digits + str(-luhn % 10)).replace(digits[0] + "9", digits[0] + "a", 1)


def identity(imsi):
    return "08" + imsi[0] + "9" + "".join(imsi[i + 1] + imsi[i] for i in range(1, 15, 2))


def bits(fields):
    text = "".join(format(value, "0%db" % width) for value, width in fields)
    return "%032x" % int(text.ljust(128, "0"), 2)


def sequence(seed, number, own, cells):
    """Measurement results of one mobile: levels that wander, rise or fall, neighbours that come and go, bad quality, DTX."""
    chance = random.Random(seed * 1000 + number)
    others = sorted(cell[1] for cell in cells if cell != own)
    codes = {cell[1]: cell[2] for cell in cells}
    level = chance.uniform(8, 50)
    drift = chance.choice([-2, -1, -0.5, -0.2, 0, 0.3])
    followed = {arfcn: [chance.uniform(3, 45), chance.choice([-0.5, 0, 0.3, 0.8, 1.5])] for arfcn in others}
    present = chance.choice([0.5, 0.9, 1.0])
    bad = chance.choice([0, 0, 0.1, 0.4])
    dtx = chance.random() < 0.2
    first = chance.choice([0, 0, 0, chance.randrange(256)])
    reduction = chance.choice([0, 0, 0, 2])
    results = []
    for index in range(60):
        level = min(63, max(0, level + drift + chance.gauss(0, 2)))
        neighbours = []
        for arfcn in others:
            state = followed[arfcn]
            state[0] = min(63, max(0, state[0] + state[1] + chance.gauss(0, 2)))
            if chance.random() < present:
                # Now and then a colour code that no tower has.
                code = codes[arfcn] if chance.random() < 0.97 else codes[arfcn] ^ 0x20
                neighbours.append((int(state[0]), others.index(arfcn), code))
        neighbours = sorted(neighbours, reverse=True)[:6]
        quality = chance.randint(5, 7) if chance.random() < bad else chance.randint(0, 4)
        sub = max(0, int(level) - chance.randint(0, 3))
        is_valid = chance.random() < 0.97
        is_known = chance.random() < 0.97
        fields = [(0, 1), (int(dtx), 1), (int(level), 6), (0, 1), (0 if is_valid else 1, 1), (sub, 6), (0, 1),
                  (quality, 3), (max(0, quality - 1), 3)]
        fields.append((len(neighbours) if is_known else 7, 3))
        for neighbour in neighbours if is_known else []:
            fields += [(neighbour[0], 6), (neighbour[1], 5), (neighbour[2], 6)]
        results.append(
            "1b%02x" % ((first + index) % 256)
            + "1903%02x%02x00" % (int(level) | (0x40 if dtx else 0), int(level))
            + "04%02x" % reduction
            + "0a00%02x" % chance.randint(0, 60)
            + "0b00120615" + bits(fields))
    return results


def main():
    host, port, seed, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4])
    cells = [tuple(int(part) for part in argument.split(":")) for argument in sys.argv[5:]]
    network = Network(host, port, cells)
    for tower in network.towers:
        network.wait(tower, lambda m: m[:2] == b"\x10\x1a", "system information")
    network.settle()
    network.register_at_last(network.towers[0], CALLED)
    callers = [network.register_at_last(network.towers[i % len(cells)], imsi) for i, imsi in enumerate(CALLERS)]
    for number in range(count):
        index = number % len(cells)
        tower = network.towers[index]
        channel = network.call(tower, callers[number % len(callers)])
        results = sequence(seed, number, cells[index], cells)
        found = network.decision(tower, channel, results)
        if found:
            index, tower, channel = found
            print("sequence=%d report=%d target=%d/%d" % (number, index, tower.arfcn, tower.bsic), flush=True)
        else:
            print("sequence=%d none" % number, flush=True)
        network.hang_up(tower, channel)


main()
