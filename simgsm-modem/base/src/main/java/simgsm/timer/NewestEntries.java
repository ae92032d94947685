package simgsm.timer;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A map for what anybody may add: the oldest of more than 10 000 entries is removed.
 *
 * @param <T> values
 */
public final class NewestEntries<T> extends LinkedHashMap<String, T> {
    private static final long serialVersionUID = 1;
    private static final int MOST = 10_000;

    /** Without entries. */
    public NewestEntries() {}

    @Override
    protected boolean removeEldestEntry(Map.Entry<String, T> eldest) {
        return size() > MOST;
    }
}
