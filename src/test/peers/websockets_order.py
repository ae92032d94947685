"""Python's websockets library as a page of the gateway: joins, orders by keys that are sent as sound, and provokes its close codes.

    websockets_order.py ws://HOST:PORT/phone KEY NUMBER FILE

FILE is A-law, 8 kHz, mono: the sound of the keys."""
import asyncio
import json
import sys

import websockets

FRAME_OCTETS = 160
FRAME_SECONDS = 0.02
SILENCE = b"\xd5" * FRAME_OCTETS

url, key, number, file = sys.argv[1:]


def connect():
    return websockets.connect(url, subprotocols=["simgsm.v1"])


async def event(socket, name, **fields):
    """The next event of this name with these fields; sound and other events are skipped."""
    async for message in socket:
        if isinstance(message, str):
            said = json.loads(message)
            if said["event"] == name and fields.items() <= said.items():
                return said
    raise SystemExit(f"closed with {socket.close_code} before {name}")


async def speak(socket, frames):
    """Sends what is in the list, one frame every 20 ms, and silence after it."""
    clock = asyncio.get_running_loop()
    due = clock.time()
    while True:
        await socket.send(frames.pop(0) if frames else SILENCE)
        due += FRAME_SECONDS
        await asyncio.sleep(max(0, due - clock.time()))


async def order():
    async with connect() as socket:
        await socket.send(json.dumps({"key": key}))
        await event(socket, "registered")
        await (await socket.ping(b"125" * 41))
        await socket.send(json.dumps({"do": "dial", "number": number}))
        await event(socket, "connected")
        frames = []
        speaking = asyncio.create_task(speak(socket, frames))
        await event(socket, "tone", key="1")
        with open(file, "rb") as sound:
            octets = sound.read()
        frames += [octets[i:i + FRAME_OCTETS] for i in range(0, len(octets), FRAME_OCTETS)]
        print("tone", (await event(socket, "tone", key="3"))["meaning"])
        speaking.cancel()


async def closed(what, *messages):
    async with connect() as socket:
        for message in messages:
            await socket.send(message)
        await socket.wait_closed()
        print(what, socket.close_code)


async def main():
    await order()
    joining = json.dumps({"key": key})
    await closed("wrong key", json.dumps({"key": "other"}))
    await closed("no JSON", "hello")
    await closed("100 octets", joining, bytes(100))
    await closed("over the limit", joining, bytes(16 * 1024 + 1))
    await closed("fragments of 100 octets", joining, [bytes(50), bytes(50)])


asyncio.run(main())
