"""Two phones behind python-gsmmodem-new: an order by SMS, USSD, calls in both directions, keys in both directions.

Usage: python_gsmmodem.py DEVICE DEVICE ROBOT
"""
import sys
import threading
import time

from gsmmodem.exceptions import TimeoutException
from gsmmodem.modem import GsmModem

PATIENCE_SECONDS = 30
ANSWER_SECONDS = 12
ATTEMPTS = 3
first_device, second_device, robot = sys.argv[1:]
received = []
incoming = []
answered = threading.Event()


def comes(condition, seconds):
    end = time.time() + seconds
    while not condition():
        if time.time() > end:
            return False
        time.sleep(0.1)
    return True


def wait(condition, what):
    if not comes(condition, PATIENCE_SECONDS):
        sys.exit("not seen: " + what)


def dial(modem, number):
    """Dials until the call is seen to be answered: the library takes a key that is reported between two of its questions
    for the answer to one, and then sees the call no more, or never sees it begin."""
    for _ in range(ATTEMPTS):
        try:
            call = modem.dial(number)
            if comes(lambda: call.answered, ANSWER_SECONDS):
                return call
        except TimeoutException:
            pass
        hang_up(modem)
        modem.dtmfpool.clear()
        incoming.clear()
    sys.exit("not answered: " + number)


def hang_up(modem):
    """Ends the call by commands: the library sends none for a call that it sees no more."""
    modem.write("ATH")
    wait(lambda: modem.write("AT+CLCC") == ["OK"], "the end of the call")


def heard(modem, keys, send):
    """Sends until the far end has reported these keys one after the other: the library loses a key that is reported
    between two of its questions."""
    found = ""
    for _ in range(ATTEMPTS):
        send()
        end = time.time() + ANSWER_SECONDS
        while time.time() < end:
            key = modem.GetIncomingDTMF()
            found += key or ""
            if found.endswith(keys):
                return
            if key is None:
                time.sleep(0.1)
    sys.exit("heard %r, expected %r" % (found, keys))


def rings(call):
    """Answers at the second ring. The library takes a RING that it reads before its +CLIP has come for a call of its own,
    without a number; that one is not answered."""
    if call.number and call.ringCount == 2:
        call.answer()
        incoming.append(call)
        answered.set()


first = GsmModem(first_device, 115200, incomingCallCallbackFunc=rings, smsReceivedCallbackFunc=received.append)
first.smsTextMode = False
first.connect()
first.waitForNetworkCoverage(PATIENCE_SECONDS)
print("network", first.networkName, "signal", first.signalStrength, "own number", first.ownNumber)

sent = first.sendSms(robot, "** #**20 **", waitForDeliveryReport=True, deliveryTimeout=PATIENCE_SECONDS)
print("delivered", sent.status == sent.DELIVERED)
# Of two notifications that arrive together the library handles the first only, so the memory is read as well.
wait(lambda: received or first.processStoredSms() or received, "the robot's reply")
print("reply", received[0].number, received[0].text)
print("ussd", first.sendUssd("*100#").message)

call = dial(first, robot)
heard(first, "3", lambda: call.sendDtmfTone("**#**20**"))
call.hangup()
hang_up(first)
print("call to the robot: its reply 3 heard")

second = GsmModem(second_device, 115200)
second.connect()
back = dial(second, first.ownNumber)
wait(answered.is_set, "the call")
heard(first, "42#", lambda: back.sendDtmfTone("42#"))
heard(second, "7", lambda: incoming[0].sendDtmfTone("7"))
incoming[0].hangup()
hang_up(first)
wait(lambda: not back.active, "the end of the call")
print("call from", incoming[0].number, "answered, keys heard in both directions")
first.close()
second.close()
