package simgsm.station;

import simgsm.air.Msisdn;
import simgsm.air.RpCause;

/** One text on its way, in all its parts: tells its user what became of it, each thing once and in order. */
final class OutgoingMessage {
    private final int id;
    private final Msisdn to;
    private final int parts;
    private final Notifications notifications;
    private int acknowledged;
    private int delivered;
    private boolean isUndelivered;

    OutgoingMessage(int id, Msisdn to, int parts, Notifications notifications) {
        this.id = id;
        this.to = to;
        this.parts = parts;
        this.notifications = notifications;
    }

    Msisdn to() {
        return to;
    }

    void partAcknowledged() {
        acknowledged++;
        if (acknowledged == parts) {
            notifications.add(listener -> listener.messageSent(id, to, parts));
            tellDelivered();
        }
    }

    /** A status report may be faster than the last acknowledgement. */
    void partDelivered() {
        delivered++;
        if (acknowledged == parts) {
            tellDelivered();
        }
    }

    /** Told once, whichever part it was. @param status TP-ST */
    void partUndelivered(int status) {
        if (!isUndelivered) {
            isUndelivered = true;
            notifications.add(listener -> listener.messageUndelivered(id, to, status));
        }
    }

    private void tellDelivered() {
        if (delivered == parts) {
            notifications.add(listener -> listener.messageDelivered(id, to));
        }
    }

    void failed(RpCause cause) {
        notifications.add(listener -> listener.messageFailed(id, to, cause));
    }
}
