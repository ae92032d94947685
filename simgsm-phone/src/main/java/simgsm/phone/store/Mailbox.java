package simgsm.phone.store;

import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import simgsm.phone.store.StoredMessage.Delivery;
import simgsm.station.context.StationEvent;

/** Messages by folder, oldest first; a full folder drops its oldest message. */
public final class Mailbox {
    /** Messages in a folder. */
    public static final int CAPACITY = 500;

    private final InstantSource wallClock;
    private int lastSerial;
    private final Map<MessageFolder, List<StoredMessage>> folders = new EnumMap<>(MessageFolder.class);

    public Mailbox(InstantSource wallClock) {
        this.wallClock = wallClock;
        for (MessageFolder folder : MessageFolder.values()) {
            folders.put(folder, List.of());
        }
    }

    /** A copy; its lists never change. */
    public Map<MessageFolder, List<StoredMessage>> folders() {
        return Map.copyOf(folders);
    }

    /** Unmodifiable; each change makes a new list, so a snapshot may keep it. */
    public List<StoredMessage> in(MessageFolder folder) {
        return folders.get(folder);
    }

    /** @return the folder to which a message was added, if one was */
    public Optional<MessageFolder> accept(StationEvent.OfMessage event) {
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
        add(folder, message(party, text, false, Delivery.RECEIVED, 0, parts));
        return folder;
    }

    /** Adds a message accepted by the station. */
    public void submitted(int id, String to, String text) {
        add(MessageFolder.OUTBOX, message(to, text, true, Delivery.SENDING, id, 1));
    }

    /** Keeps a text not yet sent. @param to empty if unknown */
    public void keepDraft(String to, String text) {
        add(MessageFolder.DRAFTS, message(to, text, true, Delivery.DRAFT, 0, 1));
    }

    /** Adds a message of an earlier run, with a new serial. */
    void restore(MessageFolder folder, StoredMessage kept) {
        add(
                folder,
                new StoredMessage(
                        ++lastSerial,
                        kept.party(),
                        kept.text(),
                        kept.at(),
                        kept.read(),
                        kept.delivery(),
                        kept.id(),
                        kept.parts(),
                        kept.cause()));
    }

    private StoredMessage message(String party, String text, boolean read, Delivery delivery, int id, int parts) {
        return new StoredMessage(
                ++lastSerial, party, text, wallClock.instant(), read, delivery, id, parts, Optional.empty());
    }

    private void add(MessageFolder folder, StoredMessage message) {
        List<StoredMessage> messages = new ArrayList<>(in(folder));
        if (messages.size() == CAPACITY) {
            messages.remove(0);
        }
        messages.add(message);
        folders.put(folder, List.copyOf(messages));
    }

    /** Changes an open message in the outbox, unless the user has erased it. */
    private void update(int id, UnaryOperator<StoredMessage> next) {
        replace(
                MessageFolder.OUTBOX,
                message -> message.id() == id && message.isOpen() ? next.apply(message) : message);
    }

    private void replace(MessageFolder folder, UnaryOperator<StoredMessage> next) {
        List<StoredMessage> replaced = in(folder).stream().map(next).toList();
        if (!replaced.equals(in(folder))) {
            folders.put(folder, replaced);
        }
    }

    /** The messages of a folder, newest first. */
    public List<StoredMessage> newest(MessageFolder folder) {
        List<StoredMessage> messages = new ArrayList<>(in(folder));
        Collections.reverse(messages);
        return messages;
    }

    /** The current version of the message; empty if it is erased. */
    public Optional<StoredMessage> find(MessageFolder folder, int serial) {
        return in(folder).stream().filter(message -> message.serial() == serial).findFirst();
    }

    public void markRead(MessageFolder folder, int serial) {
        replace(folder, message -> message.serial() == serial ? message.seen() : message);
    }

    public void markAllRead(MessageFolder folder) {
        replace(folder, StoredMessage::seen);
    }

    public void remove(MessageFolder folder, StoredMessage message) {
        folders.put(
                folder,
                in(folder).stream()
                        .filter(kept -> kept.serial() != message.serial())
                        .toList());
    }

    /** Erases all messages of a folder. */
    public void clear(MessageFolder folder) {
        folders.put(folder, List.of());
    }

    public int unread(MessageFolder folder) {
        return (int) in(folder).stream().filter(message -> !message.read()).count();
    }

    /** True if any message is unacknowledged by the network. */
    public boolean hasUnacknowledged() {
        return in(MessageFolder.OUTBOX).stream().anyMatch(message -> message.delivery() == Delivery.SENDING);
    }
}
