"""ARIA's demo and wander on SimRobot's P2OS port: aria_drive.py EXAMPLES WORLD SECONDS. Started by aria.sh."""
import math
import os
import pty
import subprocess
import sys
import threading
import time

EXAMPLES, WORLD, SECONDS = sys.argv[1], sys.argv[2], float(sys.argv[3])
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', '..')


class Lines:
    """What a program prints, with the time at which each line came."""

    def __init__(self, command, terminal=False):
        """A terminal for programs that read keys: at a pipe, ARIA's wait for a key that never comes."""
        self.began = time.monotonic()
        self.lines = []
        ours, theirs = pty.openpty() if terminal else (None, subprocess.PIPE)
        self.program = subprocess.Popen(command, stdin=theirs, stdout=theirs, stderr=subprocess.STDOUT)
        self.output = os.fdopen(ours, 'rb') if terminal else self.program.stdout
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        try:
            for line in self.output:
                self.lines.append((time.monotonic() - self.began, line.decode(errors='replace').rstrip()))
        except OSError:
            pass  # how the end of a terminal's program shows

    def wait(self, text, seconds, after=0):
        """The index of the first line with the text, not before the given one."""
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            for i in range(after, len(self.lines)):
                if text in self.lines[i][1]:
                    return i
            time.sleep(0.002)
        sys.exit('no "%s" within %d s; the last lines are:\n%s'
                 % (text, seconds, '\n'.join(line for _, line in self.lines[-20:])))

    def say(self, line):
        self.program.stdin.write((line + '\n').encode())
        self.program.stdin.flush()


def field(line, name):
    return line.split(name + '=')[1].split()[0]


def main():
    window = [] if os.environ.get('SIMROBOT_WINDOW') else ['--headless']
    robot = Lines(['java', '-jar', os.path.join(ROOT, 'target', 'dist', 'simrobot.jar'), '--serve', '--no-sound',
                   '--lang', 'en', '--world', WORLD, '--p2os', '8101' if window == [] else '0'] + window)
    try:
        port = '8101' if window == [] else field(robot.lines[robot.wait('ready', 20)][1], 'p2os')
        time.sleep(3 if window == [] else 0)
        for name in ('demo', 'wander'):
            aria = Lines([os.path.join(EXAMPLES, name), '-rh', '127.0.0.1', '-rrtp', port], terminal=True)
            try:
                connected = aria.lines[aria.wait('Connected to simulator', 40)][0]
                laser = aria.lines[aria.wait('Connected to simulated laser', 40)][0]
                print('%s: robot after %.2f s, laser after %.2f s' % (name, connected, laser), flush=True)
                if name == 'wander':
                    drive(robot, aria, window)
            finally:
                aria.program.kill()
                aria.program.wait()
    finally:
        robot.program.kill()


def drive(robot, aria, window):
    if not window:
        time.sleep(SECONDS)
        return
    moving = robot.wait('value=Moving', 20)
    print('wander: drives %.2f s after its start' % (robot.began + robot.lines[moving][0] - aria.began), flush=True)
    meters, last = 0, None
    for _ in range(int(SECONDS * 2)):
        seen = len(robot.lines)
        robot.say('pose')
        line = robot.lines[robot.wait('pose robot=', 5, seen)][1]
        here = float(field(line, 'x')), float(field(line, 'y'))
        meters += math.dist(here, last or here)
        last = here
        time.sleep(0.5)
    collisions = sum('value=Collision' in line for _, line in robot.lines)
    print('wander: %.1f m in %.0f s, %d collisions' % (meters, SECONDS, collisions), flush=True)


main()
