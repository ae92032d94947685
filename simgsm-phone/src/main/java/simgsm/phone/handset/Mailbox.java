package simgsm.phone.handset;

import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import simgsm.air.RpCause;
import simgsm.phone.handset.StoredMessage.Delivery;

/** Inbox, outbox and broadcasts, oldest first; a full box forgets its oldest. */
final class Mailbox {
    static final int CAPACITY = 500;

    private final Map<MessageFolder, List<StoredMessage>> boxes = new EnumMap<>(MessageFolder.class);

    Mailbox() {
        for (MessageFolder box : MessageFolder.values()) {
            boxes.put(box, List.of());
        }
    }

    /** Unmodifiable; a new list at each change, so a snapshot may keep it. */
    List<StoredMessage> in(MessageFolder box) {
        return boxes.get(box);
    }

    void received(String from, String text, Instant at) {
        add(MessageFolder.INBOX, new StoredMessage(from, text, at, false, Delivery.RECEIVED, 0, 1, Optional.empty()));
    }

    void broadcast(int channel, int pages, String text, Instant at) {
        String party = Integer.toString(channel);
        add(
                MessageFolder.BROADCASTS,
                new StoredMessage(party, text, at, false, Delivery.RECEIVED, 0, pages, Optional.empty()));
    }

    void handedIn(int id, String to, String text, Instant at) {
        add(MessageFolder.OUTBOX, new StoredMessage(to, text, at, true, Delivery.SENDING, id, 1, Optional.empty()));
    }

    private void add(MessageFolder box, StoredMessage message) {
        List<StoredMessage> messages = new ArrayList<>(in(box));
        if (messages.size() == CAPACITY) {
            messages.remove(0);
        }
        messages.add(message);
        boxes.put(box, List.copyOf(messages));
    }

    void sent(int id, int parts) {
        replaceOpen(id, message -> message.advanced(Delivery.SENT, parts));
    }

    void delivered(int id) {
        replaceOpen(id, message -> message.advanced(Delivery.DELIVERED, message.parts()));
    }

    /** The network has given it up after all. */
    void undelivered(int id) {
        replaceOpen(id, message -> message.advanced(Delivery.FAILED, message.parts()));
    }

    /** @return whether the message lies here */
    boolean failed(int id, RpCause cause) {
        return replaceOpen(id, message -> message.failed(cause));
    }

    /** References run from 0 to 255 and come round, so the newest that is not settled is meant. */
    private boolean replaceOpen(int id, UnaryOperator<StoredMessage> next) {
        List<StoredMessage> messages = new ArrayList<>(in(MessageFolder.OUTBOX));
        for (int i = messages.size() - 1; i >= 0; i--) {
            StoredMessage message = messages.get(i);
            boolean open = message.delivery() == Delivery.SENDING || message.delivery() == Delivery.SENT;
            if (message.id() == id && open) {
                messages.set(i, next.apply(message));
                boxes.put(MessageFolder.OUTBOX, List.copyOf(messages));
                return true;
            }
        }
        return false;
    }

    /** The newest of one's own messages with this reference. */
    Optional<StoredMessage> own(int id) {
        List<StoredMessage> messages = in(MessageFolder.OUTBOX);
        for (int i = messages.size() - 1; i >= 0; i--) {
            if (messages.get(i).id() == id) {
                return Optional.of(messages.get(i));
            }
        }
        return Optional.empty();
    }

    /** Marks one as read. @param index counted from the oldest */
    void markRead(MessageFolder box, int index) {
        List<StoredMessage> messages = new ArrayList<>(in(box));
        messages.set(index, messages.get(index).seen());
        boxes.put(box, List.copyOf(messages));
    }

    void markAllRead(MessageFolder box) {
        boxes.put(box, in(box).stream().map(StoredMessage::seen).toList());
    }

    void remove(MessageFolder box, StoredMessage message) {
        int index = in(box).indexOf(message);
        if (index >= 0) {
            remove(box, index);
        }
    }

    void remove(MessageFolder box, int index) {
        List<StoredMessage> messages = new ArrayList<>(in(box));
        messages.remove(index);
        boxes.put(box, List.copyOf(messages));
    }

    int unread(MessageFolder box) {
        return (int) in(box).stream().filter(message -> !message.read()).count();
    }

    /** Whether the network has still to acknowledge something. */
    boolean hasUnacknowledged() {
        return in(MessageFolder.OUTBOX).stream().anyMatch(message -> message.delivery() == Delivery.SENDING);
    }
}
