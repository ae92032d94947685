package simgsm.scope;

/** Two cursors on a picture with a time axis and, for a spectrogram, a frequency axis. Not thread-safe. */
public final class ScopeCursors {
    /** A place: milliseconds from the left edge, and a frequency; 0 Hz without such an axis. */
    public record CursorPlace(double millis, double hertz) {}

    private final double spanMillis;
    private final double leastHertz;
    private final double mostHertz;
    private final CursorPlace[] places;

    /**
     * Cursors at a third and two thirds of the picture.
     *
     * @param leastHertz as {@code mostHertz} for a picture without a frequency axis
     */
    public ScopeCursors(double spanMillis, double leastHertz, double mostHertz) {
        this.spanMillis = spanMillis;
        this.leastHertz = leastHertz;
        this.mostHertz = mostHertz;
        double range = mostHertz - leastHertz;
        places = new CursorPlace[] {
            new CursorPlace(spanMillis / 3, leastHertz + range / 3),
            new CursorPlace(spanMillis * 2 / 3, leastHertz + range * 2 / 3)
        };
    }

    /** @param cursor 0 or 1 */
    public CursorPlace place(int cursor) {
        return places[cursor];
    }

    public boolean hasFrequencies() {
        return mostHertz > leastHertz;
    }

    /** Moves a cursor, at most to the picture's edge. */
    public void move(int cursor, double millis, double hertz) {
        put(cursor, places[cursor].millis() + millis, places[cursor].hertz() + hertz);
    }

    /** Moves a cursor to a place, or the nearest one on the picture. */
    public void put(int cursor, double millis, double hertz) {
        places[cursor] = new CursorPlace(
                Math.max(0, Math.min(spanMillis, millis)), Math.max(leastHertz, Math.min(mostHertz, hertz)));
    }

    /** The cursor nearest to a place, by shares of the axes. */
    public int nearest(double millis, double hertz) {
        return distance(0, millis, hertz) <= distance(1, millis, hertz) ? 0 : 1;
    }

    private double distance(int cursor, double millis, double hertz) {
        double frequencies = hasFrequencies() ? (places[cursor].hertz() - hertz) / (mostHertz - leastHertz) : 0;
        return Math.hypot((places[cursor].millis() - millis) / spanMillis, frequencies);
    }

    /** From the first to the second. */
    public double differenceMillis() {
        return places[1].millis() - places[0].millis();
    }

    /** From the first to the second. */
    public double differenceHertz() {
        return places[1].hertz() - places[0].hertz();
    }

    /** The frequency with the period between the cursors; infinite if they are at one time. */
    public double periodHertz() {
        return 1000 / Math.abs(differenceMillis());
    }
}
