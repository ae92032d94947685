"""TinyGSM's and FONA's calls at the phone's AT port: arduino_calls.py FOLDER PROFILE. Started by arduino.sh."""
import os
import subprocess
import sys
import tempfile
import threading
import time

FOLDER, PROFILE = sys.argv[1], sys.argv[2]
DIST = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', '..', 'target', 'dist')
IMEI = '490154203237518'


class Program:
    """A program of the suite on its console."""

    def __init__(self, jar, *arguments):
        self.lines = []
        self.process = subprocess.Popen(
            ['java', '-jar', os.path.join(DIST, jar), '--headless', '--lang', 'en'] + list(arguments),
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        threading.Thread(target=lambda: self.lines.extend(iter(self.process.stdout.readline, '')), daemon=True).start()

    def field(self, event, name):
        until = time.monotonic() + 30
        while time.monotonic() < until:
            for line in list(self.lines):
                if line.startswith(event + ' '):
                    return line.split(name + '=')[1].split()[0]
            time.sleep(0.02)
        sys.exit('no %s within 30 s: %s' % (event, self.lines))

    def say(self, line):
        self.process.stdin.write(line + '\n')
        self.process.stdin.flush()


def calls(client, center, robot):
    """A client with a new phone and a second phone that calls it and writes to it."""
    at = ['--at', '0'] + (['--at-profile', PROFILE] if PROFILE != 'none' else [])
    phone = Program('simgsm-phone.jar', '--center', center, '--no-sound', '--number', '5550100', '--imei', IMEI, *at)
    other = Program('simgsm-phone.jar', '--center', center, '--no-sound', '--number', '5550101')
    wishes = {'call': 'dial 5550100', 'message': 'sms 5550100 hello'}
    try:
        port = phone.field('ready', 'at')
        phone.field('registered', 'number')
        other.field('registered', 'number')
        library = subprocess.Popen([os.path.join(FOLDER, client), port, IMEI], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, text=True)
        for line in library.stdout:
            print(client + ': ' + line, end='', flush=True)
            if line.startswith('want '):
                other.say(wishes[line.split()[1]])
                library.stdin.write('\n')
                library.stdin.flush()
        return library.wait()
    finally:
        phone.process.kill()
        other.process.kill()


def main():
    data = tempfile.TemporaryDirectory()
    center = Program('simgsm-center.jar', '--port', '0', '--data', data.name)
    robot = None
    try:
        address = '127.0.0.1:' + center.field('ready', 'port')
        robot = Program('simrobot.jar', '--serve', '--no-sound', '--center', address, '--number', '5550200')
        robot.field('registered', 'number')
        failed = [client for client in ('tinygsm', 'fona') if calls(client, address, robot) != 0]
        sys.exit('wrong results: ' + ', '.join(failed) if failed else 0)
    finally:
        for program in (robot, center):
            if program:
                program.process.kill()


main()
