package simgsm.timer;

import java.util.LinkedHashMap;
import java.util.Map;

/** A map of limited size: beyond it, each new key removes the oldest one. */
public final class BoundedMap<K, V> extends LinkedHashMap<K, V> {
    private static final long serialVersionUID = 1;

    private final int maxSize;

    public BoundedMap(int maxSize) {
        this.maxSize = maxSize;
    }

    /** A map of at most 10 000 entries, for what anybody may add. */
    public BoundedMap() {
        this(10_000);
    }

    /** Puts a value under a key that becomes the newest, even if it was present. */
    public void putNewest(K key, V value) {
        remove(key);
        put(key, value);
    }

    @Override
    protected boolean removeEldestEntry(Map.Entry<K, V> eldest) {
        return size() > maxSize;
    }
}
