"""Twenty orders by SMS on AMRISim: amrisim_orders.py AMRISIM_FOLDER MODEL

Starts AMRISim, a relay that reads the true pose (SIM_STAT) and the heading (information packets) on the line, a centre, a
phone and SimRobot with --pioneer. Prints a line for each order: order, tone, seconds, error in mm and in degrees; ends with
0 if each is within 5 mm and 0.5 degrees and answered by 3.
"""

import math
import os
import re
import socket
import struct
import subprocess
import sys
import threading
import time

ORDERS = [
    "#**1", "#*#1", "#**2", "#*#5", "#**5", "#*#45", "#**10", "#*#90", "#**20", "#*#180",
    "#**50", "#*#10", "#**99", "#*#270", "#**100", "#*#360", "#**200", "#*#359", "#**7", "#**500",
]
MOST_MILLIMETERS, MOST_DEGREES = 5, 0.5
folder, model = sys.argv[1], sys.argv[2]
programs = []


def packet(data):
    total = 0
    for i in range(0, len(data) - 1, 2):
        total = (total + (data[i] << 8 | data[i + 1])) & 0xFFFF
    if len(data) % 2:
        total ^= data[-1]
    return b"\xfa\xfb" + bytes([len(data) + 2]) + data + struct.pack(">H", total)


class Relay:
    """Between SimRobot and AMRISim; asks for SIM_STAT and keeps its answers."""

    def __init__(self, port):
        self.true = None
        self.heading = 0.0
        self.turned = 0.0
        self.sent = {}
        self.last = None
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.port = self.listening.getsockname()[1]
        self.peer_port = port
        threading.Thread(target=self.run, daemon=True).start()

    def run(self):
        while True:
            client = self.listening.accept()[0]
            server = socket.create_connection(("127.0.0.1", self.peer_port))
            self.server = server
            threading.Thread(target=self.forward, args=(client, server, self.count), daemon=True).start()
            threading.Thread(target=self.forward, args=(server, client, self.look), daemon=True).start()

    def forward(self, source, to, see):
        rest = b""
        try:
            while chunk := source.recv(4096):
                to.sendall(chunk)
                rest += chunk
                while len(rest) > 3 and len(rest) >= 3 + rest[2]:
                    if rest[:2] != b"\xfa\xfb":
                        rest = rest[1:]
                        continue
                    see(rest[3 : 1 + rest[2]])
                    rest = rest[3 + rest[2] :]
        except OSError:
            pass
        to.close()

    def count(self, data):
        self.sent[data[0]] = self.sent.get(data[0], 0) + 1

    def look(self, data):
        if data[0] in (0x32, 0x33) and len(data) > 7:
            now = struct.unpack_from("<h", data, 5)[0]
            if self.last is not None:
                self.turned += ((now - self.last + 2048) % 4096 - 2048) * 360 / 4096
            self.last = now
        elif data[0] == 0x62:
            x, y = struct.unpack_from("<ii", data, 1 + 2 + 4 + 6)
            self.true = (x, y)

    def pose(self):
        """The true x and y, and the sum of all turns, anticlockwise."""
        self.true = None
        self.server.sendall(packet(bytes([237, 0x3B, 1, 0])))
        for _ in range(100):
            if self.true:
                return (*self.true, self.turned)
            time.sleep(0.05)
        sys.exit("AMRISim gives no true pose")


class Program:
    def __init__(self, *command, **more):
        self.lines = []
        self.came = threading.Condition()
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, **more
        )
        programs.append(self)
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        for line in self.process.stdout:
            with self.came:
                self.lines.append(line.strip())
                self.came.notify_all()

    def say(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def expect(self, pattern, seconds):
        """The next line that matches; lines before it are dropped."""
        end = time.time() + seconds
        with self.came:
            while True:
                for i, line in enumerate(self.lines):
                    if found := re.search(pattern, line):
                        del self.lines[: i + 1]
                        return found
                if time.time() >= end:
                    sys.exit(f"no {pattern} within {seconds} s in {self.lines[-5:]}")
                self.came.wait(end - time.time())


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as probe:
        return probe.getsockname()[1]


def main():
    dist = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../target/dist")
    java = lambda jar, *options: Program("java", "-jar", f"{dist}/{jar}.jar", "--headless", *options)
    port = free_port()
    # no connection to try the port: AMRISim serves the first one and then moves to another port
    Program(
        f"{folder}/AMRISim", "--nomap", "--noninteractive", "-r", f"{model}:robot", "-p", str(port),
        env={**os.environ, "AMRISIM": folder}, cwd=folder,
    )
    listening = f":{port:04X} 00000000:0000 0A"
    for _ in range(300):
        if listening in open("/proc/net/tcp").read():
            break
        time.sleep(0.1)
    relay = Relay(port)
    center = java("simgsm-center", "--port=0", "--data=" + os.path.join(folder, "orders-data")).expect(r"port=(\d+)", 30)[1]
    robot = java("simrobot", f"--center=127.0.0.1:{center}", "--no-sound", f"--pioneer=127.0.0.1:{relay.port}")
    phone = java("simgsm-phone", f"--center=127.0.0.1:{center}", "--no-sound", "--number=5550100")
    robot.expect(r"status .*value=Stopped", 60)
    phone.expect("registered", 30)
    time.sleep(2)
    good = 0
    for order in ORDERS:
        x, y, heading = relay.pose()
        begun = time.time()
        phone.say(f"sms 5550200 ** {order} **")
        reply = phone.expect(r'^sms from=5550200 text="(.*)"', 120)[1]
        took = time.time() - begun
        time.sleep(1)
        after = relay.pose()
        amount = int(order[3:])
        ahead, turn = (amount * 10, 0) if order[2] == "*" else (0, amount)
        way = math.hypot(after[0] - x, after[1] - y)
        millimeters, degrees = way - ahead, heading - after[2] - turn
        fine = reply.startswith("3 ") and abs(millimeters) <= MOST_MILLIMETERS and abs(degrees) <= MOST_DEGREES
        good += fine
        print(f"{order:7} {reply[:8]:9} {took:5.1f} s {millimeters:+6.1f} mm {degrees:+6.2f} degrees"
              + ("" if fine else "   <-- " + reply), flush=True)
    print(f"{good} of {len(ORDERS)}; MOVE {relay.sent.get(8, 0)}, DHEAD {relay.sent.get(13, 0)}, VEL {relay.sent.get(11, 0)}")
    return good == len(ORDERS)


try:
    ended_well = main()
finally:
    for program in programs:
        program.process.kill()  # AMRISim does not end by SIGTERM
sys.exit(0 if ended_well else 1)
