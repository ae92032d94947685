"""Drives the robot with python-smpplib: smpplib_order.py PORT NUMBER ROBOT ORDER

Binds as a transceiver for NUMBER, submits ORDER to ROBOT with a receipt asked for, and prints
"receipt STATE" and "reply TEXT" as they come; ends with 0 once both are there.
"""

import logging
import sys

import smpplib.client
import smpplib.consts

logging.disable(logging.CRITICAL)
port, number, robot, order = int(sys.argv[1]), sys.argv[2], sys.argv[3], sys.argv[4]
seen = set()


def received(pdu):
    text = pdu.short_message.decode("latin-1")
    if pdu.esm_class & 0x04:
        print("receipt", text.split("stat:")[1].split()[0])
        seen.add("receipt")
    else:
        print("reply", text)
        seen.add("reply")
    return 0


client = smpplib.client.Client("127.0.0.1", port)
client.set_message_received_handler(received)
client.set_message_sent_handler(lambda pdu: print("submitted", pdu.message_id.decode()))
client.connect()
client.bind_transceiver(system_id="smpplib", password="", address_range=number)
client.send_message(
    source_addr_ton=smpplib.consts.SMPP_TON_INTL,
    source_addr_npi=smpplib.consts.SMPP_NPI_ISDN,
    source_addr=number,
    dest_addr_ton=smpplib.consts.SMPP_TON_INTL,
    dest_addr_npi=smpplib.consts.SMPP_NPI_ISDN,
    destination_addr=robot,
    short_message=order.encode("ascii"),
    data_coding=0,
    registered_delivery=True,
)
while seen != {"receipt", "reply"}:
    client.read_once()
client.unbind()
client.disconnect()
