package simgsm.phone.store;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import simgsm.phone.store.StoredMessage.Delivery;
import simgsm.sim.SimPhoneBook;

/**
 * The stored data as texts by key: {@code name.PLACE}, {@code call.N} and {@code message.N}; tabs separate the parts
 * of a text.
 */
public final class PhoneImage {
    private static final String NAME = "name.";
    private static final String CALL = "call.";
    private static final String MESSAGE = "message.";
    private static final String TAB = "\t";
    private static final int NAME_PARTS = 2;
    private static final int CALL_PARTS = 4;
    private static final int MESSAGE_PARTS = 7;

    private final SimPhoneBook book;
    private final CallLog log;
    private final Mailbox mailbox;
    private List<?> known = List.of();

    public PhoneImage(SimPhoneBook book, CallLog log, Mailbox mailbox) {
        this.book = book;
        this.log = log;
        this.mailbox = mailbox;
    }

    /** True if something has changed since the last call. */
    public boolean hasChanged() {
        List<?> now = List.of(book.version(), log.records(), mailbox.folders());
        boolean isNew = !now.equals(known);
        known = now;
        return isNew;
    }

    /** All data to be stored. */
    public SortedMap<String, String> texts() {
        SortedMap<String, String> texts = new TreeMap<>();
        book.entries().forEach((place, entry) -> texts.put(NAME + place, entry.number() + TAB + entry.name()));
        List<CallRecord> calls = log.records();
        for (int i = 0; i < calls.size(); i++) {
            texts.put(numbered(CALL, i), textOf(calls.get(i)));
        }
        int next = 0;
        for (MessageFolder folder : MessageFolder.values()) {
            for (StoredMessage message : mailbox.in(folder)) {
                texts.put(numbered(MESSAGE, next++), textOf(folder, message));
            }
        }
        return texts;
    }

    /** Keys in the order of their numbers. */
    private static String numbered(String family, int number) {
        return String.format(Locale.ROOT, "%s%04d", family, number);
    }

    private static String textOf(CallRecord call) {
        return String.join(
                TAB,
                call.kind().name(),
                call.number(),
                String.valueOf(call.at().getEpochSecond()),
                String.valueOf(call.seconds()));
    }

    private static String textOf(MessageFolder folder, StoredMessage message) {
        return String.join(
                TAB,
                folder.name(),
                message.party(),
                String.valueOf(message.at().getEpochSecond()),
                String.valueOf(message.read()),
                message.delivery().name(),
                String.valueOf(message.parts()),
                message.text());
    }

    /** Restores the stored texts; keys of other families are ignored. @return the keys of invalid texts */
    public List<String> restore(Map<String, String> texts) {
        List<String> wrong = new ArrayList<>();
        new TreeMap<>(texts).forEach((key, text) -> {
            try {
                restore(key, text);
            } catch (IllegalArgumentException e) {
                wrong.add(key);
            }
        });
        log.missedSeen();
        return wrong;
    }

    private void restore(String key, String text) {
        if (key.startsWith(NAME)) {
            List<String> parts = parts(text, NAME_PARTS);
            book.write(
                    Integer.parseInt(key.substring(NAME.length())), new SimPhoneBook.Entry(parts.get(0), parts.get(1)));
        } else if (key.startsWith(CALL)) {
            List<String> parts = parts(text, CALL_PARTS);
            log.add(new CallRecord(
                    CallRecord.Kind.valueOf(parts.get(0)),
                    parts.get(1),
                    instant(parts.get(2)),
                    Integer.parseInt(parts.get(3))));
        } else if (key.startsWith(MESSAGE)) {
            restoreMessage(parts(text, MESSAGE_PARTS));
        }
    }

    /** Restores a message; one interrupted while sending counts as failed. */
    private void restoreMessage(List<String> parts) {
        Delivery delivery = Delivery.valueOf(parts.get(4));
        mailbox.restore(
                MessageFolder.valueOf(parts.get(0)),
                new StoredMessage(
                        0,
                        parts.get(1),
                        parts.get(6),
                        instant(parts.get(2)),
                        Boolean.parseBoolean(parts.get(3)),
                        delivery == Delivery.SENDING ? Delivery.FAILED : delivery,
                        StoredMessage.NO_ID,
                        Integer.parseInt(parts.get(5)),
                        Optional.empty()));
    }

    private static Instant instant(String seconds) {
        return Instant.ofEpochSecond(Long.parseLong(seconds));
    }

    private static List<String> parts(String text, int count) {
        List<String> parts = Arrays.asList(text.split(TAB, count));
        if (parts.size() != count) {
            throw new IllegalArgumentException("expected " + count + " parts, found " + parts.size());
        }
        return parts;
    }
}
