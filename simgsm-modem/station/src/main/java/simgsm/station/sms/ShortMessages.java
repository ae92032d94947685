package simgsm.station.sms;

import java.lang.System.Logger.Level;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.ShortMessageControl.CpError;
import simgsm.octets.OctetString;
import simgsm.sms.BroadcastCollector;
import simgsm.sms.CellBroadcastPage;
import simgsm.sms.ChannelList;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;
import simgsm.station.mobility.ServiceRequests;

/** Short messages in both directions, and cell broadcast. */
public final class ShortMessages {
    /** CP cause: invalid transaction identifier value (TS 24.011, 8.1.4.2). */
    private static final int INVALID_TRANSACTION_IDENTIFIER = 81;

    private final StationContext context;
    private final MessageSender sender;
    private final MessageReceiver receiver;
    private final BroadcastCollector broadcasts = new BroadcastCollector();
    private ChannelList channels = ChannelList.ALL;

    public ShortMessages(StationContext context, ServiceRequests services, int firstReference) {
        this.context = context;
        DeliveryReports reports = new DeliveryReports(context.log());
        sender = new MessageSender(context, services, reports, firstReference);
        receiver = new MessageReceiver(context, reports);
    }

    /** The user of connections for outgoing messages. */
    public ServiceRequests.ServiceUser sender() {
        return sender;
    }

    /** Queues a text. @return the message's id */
    public int send(Msisdn to, String text) {
        return sender.send(to, text);
    }

    /** Queues a transfer unit made by the terminal. @return the message's id */
    public int submit(OctetString tpdu, Msisdn to, Msisdn serviceCenter) {
        return sender.submit(tpdu, to, serviceCenter);
    }

    /** All queued messages fail. */
    public void powerOff() {
        sender.powerOff();
    }

    public void setChannels(ChannelList newChannels) {
        channels = newChannels;
    }

    public void setMemoryAvailable(boolean available) {
        if (!available) {
            receiver.memoryFull();
        } else if (receiver.memoryAvailable()) {
            sender.sendMemoryAvailable();
        }
    }

    public void answersLater() {
        receiver.answersLater();
    }

    public void messageTaken() {
        receiver.taken();
    }

    public void messageRefused(RpCause cause) {
        receiver.refused(cause);
    }

    public void radioLost() {
        receiver.radioLost();
    }

    public void linkLost() {
        receiver.linkLost();
    }

    /** True if a received message needs the radio connection; the sender requests its own. */
    public boolean isBusy() {
        return receiver.isBusy();
    }

    public void arrived(ShortMessageControl message) {
        if (message.transaction().fromOtherSide()) {
            arrivedForSender(message);
        } else if (message instanceof CpData data) {
            receiver.arrived(data);
        } else {
            receiver.ended(message.transaction(), message instanceof CpAck);
        }
    }

    private void arrivedForSender(ShortMessageControl message) {
        if (!sender.has(message.transaction())) {
            refuseUnknown(message);
        } else if (message instanceof CpData data) {
            sender.answered(data.relay());
        } else if (message instanceof CpAck) {
            sender.acknowledged();
        } else if (message instanceof CpError error) {
            sender.failed(error.cause());
        }
    }

    /** TS 24.011, 9.2.1. */
    private void refuseUnknown(ShortMessageControl message) {
        context.log().trace(Level.DEBUG, "{0} of an unknown transaction", message);
        if (message instanceof CpData) {
            context.radio().send(new CpError(message.transaction().answered(), INVALID_TRANSACTION_IDENTIFIER));
        }
    }

    public void broadcastArrived(OctetString page) {
        try {
            CellBroadcastPage received = CellBroadcastPage.decode(page);
            context.events().add(new StationEvent.BroadcastPageReceived(page));
            if (channels.contains(received.messageIdentifier())) {
                broadcasts
                        .accept(received)
                        .ifPresent(message -> context.events()
                                .add(new StationEvent.BroadcastReceived(
                                        message.messageIdentifier(), message.pages(), message.text())));
            }
        } catch (ProtocolViolation e) {
            context.log().trace(Level.WARNING, "broadcast page dropped: {0}", e.getMessage());
        }
    }
}
