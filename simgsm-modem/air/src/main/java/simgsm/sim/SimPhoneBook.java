package simgsm.sim;

import java.util.Collections;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** The abbreviated dialling numbers of a SIM (EF ADN of TS 51.011, 10.5.1), written by the user. */
public final class SimPhoneBook {
    /** Entries; their places are counted from 1. */
    public static final int CAPACITY = 100;

    public static final int MOST_DIGITS = 20;
    public static final int MOST_LETTERS = 20;

    /** @param number of {@code 0-9*#}, with + for an international one */
    public record Entry(String number, String name) {}

    private final Map<Integer, Entry> entries = new TreeMap<>();
    private int version;
    private Runnable whenChanged = () -> {};

    /** An empty book. */
    public SimPhoneBook() {}

    /** The entries by place: a view. */
    public Map<Integer, Entry> entries() {
        return Collections.unmodifiableMap(entries);
    }

    /** Number of changes. */
    public int version() {
        return version;
    }

    /** Sets an action that runs after each change. */
    public void whenChanged(Runnable action) {
        whenChanged = action;
    }

    private void changed() {
        version++;
        whenChanged.run();
    }

    /** The first free place. */
    public Optional<Integer> free() {
        for (int place = 1; place <= CAPACITY; place++) {
            if (!entries.containsKey(place)) {
                return Optional.of(place);
            }
        }
        return Optional.empty();
    }

    /** @throws IllegalArgumentException for an invalid place, and for too many digits or letters */
    public void write(int place, Entry entry) {
        boolean fits = entry.number().replace("+", "").length() <= MOST_DIGITS
                && entry.name().length() <= MOST_LETTERS;
        if (place < 1 || place > CAPACITY || !fits) {
            throw new IllegalArgumentException("place " + place + ": expected places 1 to " + CAPACITY + ", "
                    + MOST_DIGITS + " digits and " + MOST_LETTERS + " letters at most");
        }
        entries.put(place, entry);
        changed();
    }

    public void erase(int place) {
        entries.remove(place);
        changed();
    }
}
