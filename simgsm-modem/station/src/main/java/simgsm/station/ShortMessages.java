package simgsm.station;

import java.lang.System.Logger.Level;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.ShortMessageControl;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.ShortMessageControl.CpError;
import simgsm.octets.OctetString;
import simgsm.sms.BroadcastCollector;
import simgsm.sms.CellBroadcastPage;
import simgsm.sms.ChannelList;

/** Short messages both ways, and cell broadcast. */
final class ShortMessages {
    /** CP cause: invalid transaction identifier value (TS 24.011, 8.1.4.2). */
    private static final int INVALID_TRANSACTION_IDENTIFIER = 81;

    private final StationParts parts;
    private final MessageSender sender;
    private final MessageReceiver receiver;
    private final BroadcastCollector broadcasts = new BroadcastCollector();
    private ChannelList wanted = ChannelList.ALL;

    ShortMessages(StationParts parts, ServiceRequests services, int firstReference) {
        this.parts = parts;
        DeliveryReports reports = new DeliveryReports(parts.log());
        sender = new MessageSender(parts, services, reports, firstReference);
        receiver = new MessageReceiver(parts, reports);
    }

    ServiceRequests.User sender() {
        return sender;
    }

    int send(Msisdn to, String text) {
        return sender.send(to, text);
    }

    void powerOff() {
        sender.powerOff();
    }

    void wantBroadcasts(ChannelList channels) {
        wanted = channels;
    }

    void memoryFull() {
        receiver.memoryFull();
    }

    void memoryAvailable() {
        if (receiver.memoryAvailable()) {
            sender.tellMemoryAvailable();
        }
    }

    void radioLost() {
        receiver.radioLost();
    }

    void linkLost() {
        receiver.linkLost();
    }

    /** Whether a received message still needs the radio; the sender asks for it itself. */
    boolean isBusy() {
        return receiver.isBusy();
    }

    void expired(StationTimer timer) {
        if (timer == StationTimer.TC1_INCOMING) {
            receiver.tc1Expired();
        } else {
            sender.expired(timer);
        }
    }

    void arrived(ShortMessageControl message) {
        if (message.transaction().fromOtherSide()) {
            arrivedForSender(message);
        } else if (message instanceof CpData data) {
            receiver.arrived(data);
        } else {
            receiver.ended(message.transaction(), message instanceof CpAck);
        }
    }

    private void arrivedForSender(ShortMessageControl message) {
        if (!sender.isOurs(message.transaction())) {
            refuseUnknown(message);
        } else if (message instanceof CpData data) {
            sender.answered(data.relay());
        } else if (message instanceof CpAck) {
            sender.acknowledged();
        } else if (message instanceof CpError error) {
            sender.failedAtTheOtherEnd(error.cause());
        }
    }

    /** TS 24.011, 9.2.1. */
    private void refuseUnknown(ShortMessageControl message) {
        parts.log().trace(Level.DEBUG, "{0} of an unknown transaction", message);
        if (message instanceof CpData) {
            parts.radio().send(new CpError(message.transaction().answered(), INVALID_TRANSACTION_IDENTIFIER));
        }
    }

    void broadcastArrived(OctetString page) {
        try {
            CellBroadcastPage received = CellBroadcastPage.decode(page);
            if (wanted.contains(received.messageIdentifier())) {
                broadcasts
                        .accept(received)
                        .ifPresent(message -> parts.notifications()
                                .add(listener -> listener.broadcastReceived(
                                        message.messageIdentifier(), message.pages(), message.text())));
            }
        } catch (ProtocolViolation e) {
            parts.log().trace(Level.WARNING, "broadcast page dropped: {0}", e.getMessage());
        }
    }
}
