package simgsm.phone.handset;

import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import simgsm.phone.handset.StoredMessage.Delivery;

/** Inbox, outbox and broadcasts, oldest first; a full box forgets its oldest. */
final class Mailbox {
    static final int CAPACITY = 500;

    private final Map<Box, List<StoredMessage>> boxes = new EnumMap<>(Box.class);

    Mailbox() {
        for (Box box : Box.values()) {
            boxes.put(box, List.of());
        }
    }

    /** Unmodifiable; a new list at each change, so a snapshot may keep it. */
    List<StoredMessage> in(Box box) {
        return boxes.get(box);
    }

    void received(String from, String text, Instant at) {
        add(Box.INBOX, new StoredMessage(from, text, at, false, Delivery.RECEIVED, 0, 1));
    }

    void broadcast(int channel, int pages, String text, Instant at) {
        add(Box.BROADCASTS, new StoredMessage(Integer.toString(channel), text, at, false, Delivery.RECEIVED, 0, pages));
    }

    void handedIn(int id, String to, String text, Instant at) {
        add(Box.OUTBOX, new StoredMessage(to, text, at, true, Delivery.SENDING, id, 1));
    }

    private void add(Box box, StoredMessage message) {
        List<StoredMessage> messages = new ArrayList<>(in(box));
        if (messages.size() == CAPACITY) {
            messages.remove(0);
        }
        messages.add(message);
        boxes.put(box, List.copyOf(messages));
    }

    void sent(int id, int parts) {
        advance(id, Delivery.SENT, parts);
    }

    void delivered(int id) {
        advance(id, Delivery.DELIVERED, 0);
    }

    /** @return whether the message lies here */
    boolean failed(int id) {
        return advance(id, Delivery.FAILED, 0);
    }

    /** References run from 0 to 255 and come round, so the newest that is not settled is meant. */
    private boolean advance(int id, Delivery next, int parts) {
        List<StoredMessage> messages = new ArrayList<>(in(Box.OUTBOX));
        for (int i = messages.size() - 1; i >= 0; i--) {
            StoredMessage message = messages.get(i);
            boolean open = message.delivery() == Delivery.SENDING || message.delivery() == Delivery.SENT;
            if (message.id() == id && open) {
                messages.set(i, message.advanced(next, parts > 0 ? parts : message.parts()));
                boxes.put(Box.OUTBOX, List.copyOf(messages));
                return true;
            }
        }
        return false;
    }

    /** Marks one as read. @param index counted from the oldest */
    void markRead(Box box, int index) {
        List<StoredMessage> messages = new ArrayList<>(in(box));
        messages.set(index, messages.get(index).seen());
        boxes.put(box, List.copyOf(messages));
    }

    void markAllRead(Box box) {
        boxes.put(box, in(box).stream().map(StoredMessage::seen).toList());
    }

    void remove(Box box, int index) {
        List<StoredMessage> messages = new ArrayList<>(in(box));
        messages.remove(index);
        boxes.put(box, List.copyOf(messages));
    }

    int unread(Box box) {
        return (int) in(box).stream().filter(message -> !message.read()).count();
    }

    /** Whether the network has still to acknowledge something. */
    boolean hasUnacknowledged() {
        return in(Box.OUTBOX).stream().anyMatch(message -> message.delivery() == Delivery.SENDING);
    }
}
