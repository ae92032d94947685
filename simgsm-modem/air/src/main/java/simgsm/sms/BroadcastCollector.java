package simgsm.sms;

import java.util.Arrays;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Cell broadcast in a phone: collects pages in any order and returns each message once, regardless of repetitions (TS
 * 23.041, 9.4.1.2.1). Keeps the newest {@link #MAX_MESSAGES} messages.
 */
public final class BroadcastCollector {
    public static final int MAX_MESSAGES = 64;

    private record Key(int messageIdentifier, BroadcastSerial serial) {}

    /** The pages received; null for a complete message. */
    private final Map<Key, CellBroadcastPage[]> messages = new LinkedHashMap<>();

    public BroadcastCollector() {}

    /** The whole message if this page was the last one missing. */
    public Optional<CellBroadcast> accept(CellBroadcastPage page) {
        Key key = new Key(page.messageIdentifier(), page.serial());
        if (messages.containsKey(key) && messages.get(key) == null) {
            return Optional.empty();
        }
        CellBroadcastPage[] pages = messages.get(key);
        if (pages == null || pages.length != page.pages()) {
            pages = begin(key, page.pages());
        }
        pages[page.page() - 1] = page;
        if (Arrays.stream(pages).anyMatch(Objects::isNull)) {
            return Optional.empty();
        }
        messages.put(key, null);
        return Optional.of(CellBroadcast.join(Arrays.asList(pages)));
    }

    private CellBroadcastPage[] begin(Key key, int count) {
        messages.remove(key);
        if (messages.size() == MAX_MESSAGES) {
            Iterator<Key> oldest = messages.keySet().iterator();
            oldest.next();
            oldest.remove();
        }
        CellBroadcastPage[] pages = new CellBroadcastPage[count];
        messages.put(key, pages);
        return pages;
    }
}
