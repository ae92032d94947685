package simgsm.phone.handset;

import java.time.InstantSource;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import simgsm.phone.handset.StoredMessage.Delivery;
import simgsm.station.context.StationEvent;

/** Inbox, outbox and broadcasts, oldest first; a full folder drops its oldest message. */
final class Mailbox {
    static final int CAPACITY = 500;

    private final InstantSource wallClock;
    private final Map<MessageFolder, List<StoredMessage>> folders = new EnumMap<>(MessageFolder.class);

    Mailbox(InstantSource wallClock) {
        this.wallClock = wallClock;
        for (MessageFolder folder : MessageFolder.values()) {
            folders.put(folder, List.of());
        }
    }

    /** Unmodifiable; a new list after each change, so a snapshot may keep it. */
    List<StoredMessage> in(MessageFolder folder) {
        return folders.get(folder);
    }

    /** @return the folder to which a message was added, if one was */
    Optional<MessageFolder> accept(StationEvent.OfMessage event) {
        if (event instanceof StationEvent.ShortMessageReceived message) {
            return Optional.of(received(MessageFolder.INBOX, message.from(), message.text(), 1));
        }
        if (event instanceof StationEvent.BroadcastReceived broadcast) {
            String channel = Integer.toString(broadcast.channel());
            return Optional.of(received(MessageFolder.BROADCASTS, channel, broadcast.text(), broadcast.pages()));
        }
        if (event instanceof StationEvent.MessageSent sent) {
            update(sent.id(), message -> message.advanced(Delivery.SENT, sent.parts()));
        } else if (event instanceof StationEvent.MessageFailed failed) {
            update(failed.id(), message -> message.failed(failed.cause()));
        } else if (event instanceof StationEvent.MessageDelivered delivered) {
            update(delivered.id(), message -> message.advanced(Delivery.DELIVERED, message.parts()));
        } else if (event instanceof StationEvent.MessageUndelivered undelivered) {
            update(undelivered.id(), message -> message.advanced(Delivery.FAILED, message.parts()));
        }
        return Optional.empty();
    }

    private MessageFolder received(MessageFolder folder, String party, String text, int parts) {
        add(
                folder,
                new StoredMessage(
                        party, text, wallClock.instant(), false, Delivery.RECEIVED, 0, parts, Optional.empty()));
        return folder;
    }

    /** Adds a message that the station has taken. */
    void submitted(int id, String to, String text) {
        add(
                MessageFolder.OUTBOX,
                new StoredMessage(to, text, wallClock.instant(), true, Delivery.SENDING, id, 1, Optional.empty()));
    }

    private void add(MessageFolder folder, StoredMessage message) {
        List<StoredMessage> messages = new ArrayList<>(in(folder));
        if (messages.size() == CAPACITY) {
            messages.remove(0);
        }
        messages.add(message);
        folders.put(folder, List.copyOf(messages));
    }

    /** A message that the user has erased meanwhile is not there; one that has failed or was delivered stays so. */
    private void update(int id, UnaryOperator<StoredMessage> next) {
        replace(
                MessageFolder.OUTBOX,
                message -> message.id() == id && message.isOpen() ? next.apply(message) : message);
    }

    private void replace(MessageFolder folder, UnaryOperator<StoredMessage> next) {
        folders.put(folder, in(folder).stream().map(next).toList());
    }

    /** A message of the outbox. */
    Optional<StoredMessage> submitted(int id) {
        return in(MessageFolder.OUTBOX).stream()
                .filter(message -> message.id() == id)
                .findFirst();
    }

    /** Marks one as read. @param index counted from the oldest */
    void markRead(MessageFolder folder, int index) {
        List<StoredMessage> messages = new ArrayList<>(in(folder));
        messages.set(index, messages.get(index).seen());
        folders.put(folder, List.copyOf(messages));
    }

    void markAllRead(MessageFolder folder) {
        replace(folder, StoredMessage::seen);
    }

    void remove(MessageFolder folder, StoredMessage message) {
        List<StoredMessage> messages = new ArrayList<>(in(folder));
        messages.remove(message);
        folders.put(folder, List.copyOf(messages));
    }

    int unread(MessageFolder folder) {
        return (int) in(folder).stream().filter(message -> !message.read()).count();
    }

    /** Whether the network has still to acknowledge a message. */
    boolean hasUnacknowledged() {
        return in(MessageFolder.OUTBOX).stream().anyMatch(message -> message.delivery() == Delivery.SENDING);
    }
}
