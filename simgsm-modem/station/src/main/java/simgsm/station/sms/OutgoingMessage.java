package simgsm.station.sms;

import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.station.context.PendingEvents;
import simgsm.station.context.StationEvent;

/** One text with all its parts; reports each step once and in order. */
final class OutgoingMessage {
    private final int id;
    private final Msisdn to;
    private final int parts;
    private final PendingEvents events;
    private int acknowledged;
    private int delivered;
    private boolean undelivered;

    OutgoingMessage(int id, Msisdn to, int parts, PendingEvents events) {
        this.id = id;
        this.to = to;
        this.parts = parts;
        this.events = events;
    }

    Msisdn to() {
        return to;
    }

    void partAcknowledged() {
        acknowledged++;
        if (acknowledged == parts) {
            events.add(new StationEvent.MessageSent(id, to, parts));
            reportDelivered();
        }
    }

    /** A status report may precede the last acknowledgement. */
    void partDelivered() {
        delivered++;
        if (acknowledged == parts) {
            reportDelivered();
        }
    }

    /** Reported for the first part only. @param status TP-ST */
    void partUndelivered(int status) {
        if (!undelivered) {
            undelivered = true;
            events.add(new StationEvent.MessageUndelivered(id, to, status));
        }
    }

    private void reportDelivered() {
        if (delivered == parts) {
            events.add(new StationEvent.MessageDelivered(id, to));
        }
    }

    void failed(RpCause cause) {
        events.add(new StationEvent.MessageFailed(id, to, cause));
    }
}
