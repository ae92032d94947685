package simgsm.sms;

import java.util.Arrays;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * A phone's side of cell broadcast: gathers pages in any order and gives each message once, however often the cell
 * repeats it (TS 23.041, 9.4.1.2.1). Remembers at most {@link #MAX_MESSAGES}, the oldest is forgotten first.
 */
public final class BroadcastCollector {
    public static final int MAX_MESSAGES = 64;

    private record Key(int messageIdentifier, BroadcastSerial serial) {}

    /** The pages so far; null once the message has been shown. */
    private final Map<Key, CellBroadcastPage[]> messages = new LinkedHashMap<>();

    /** With nothing shown yet. */
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
