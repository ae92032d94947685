package simgsm.phone.handset;

import java.time.InstantSource;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;

/** The handset's short messages: hands in what is written, and puts into the mailbox what comes of it and what arrives. */
final class MessageDesk {
    private final Mailbox mailbox;
    private final Screens screens;
    private final Supplier<StationSide> station;
    private final InstantSource wallClock;
    private final Runnable changed;
    /** References of messages that failed while they were being handed in. */
    private final Map<Integer, RpCause> failedEarly = new HashMap<>();

    /** @param changed run after every change */
    MessageDesk(
            Mailbox mailbox,
            Screens screens,
            Supplier<StationSide> station,
            InstantSource wallClock,
            Runnable changed) {
        this.mailbox = mailbox;
        this.screens = screens;
        this.station = station;
        this.wallClock = wallClock;
        this.changed = changed;
    }

    Optional<Refusal> send(Msisdn to, String text) {
        if (text.isEmpty()) {
            return Optional.of(Refusal.EMPTY_TEXT);
        }
        if (!station.get().snapshot().powered()) {
            return Optional.of(Refusal.SWITCHED_OFF);
        }
        int id;
        try {
            id = station.get().sendMessage(to, text);
        } catch (IllegalArgumentException tooLong) {
            return Optional.of(Refusal.TEXT_TOO_LONG);
        }
        mailbox.handedIn(id, to.digits(), text, wallClock.instant());
        RpCause early = failedEarly.remove(id);
        if (early != null) {
            mailbox.failed(id, early);
        }
        added(MessageFolder.OUTBOX);
        return Optional.empty();
    }

    /** The messages that have come, oldest first, as they are before this call marks them as read. */
    List<StoredMessage> readInbox() {
        List<StoredMessage> inbox = mailbox.in(MessageFolder.INBOX);
        mailbox.markAllRead(MessageFolder.INBOX);
        changed.run();
        return inbox;
    }

    // What the station brings.

    void sent(int id, int parts) {
        mailbox.sent(id, parts);
        changed.run();
    }

    void failed(int id, RpCause cause) {
        if (!mailbox.failed(id, cause)) {
            failedEarly.put(id, cause);
        }
        changed.run();
    }

    void delivered(int id) {
        mailbox.delivered(id);
        changed.run();
    }

    void undelivered(int id) {
        mailbox.undelivered(id);
        changed.run();
    }

    void received(String from, String text) {
        mailbox.received(from, text, wallClock.instant());
        added(MessageFolder.INBOX);
    }

    void broadcastReceived(int channel, int pages, String text) {
        mailbox.broadcast(channel, pages, text, wallClock.instant());
        added(MessageFolder.BROADCASTS);
    }

    private void added(MessageFolder box) {
        screens.added(box);
        changed.run();
    }
}
