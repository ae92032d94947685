package simgsm.net;

/** Pauses between attempts: the first, then twice the one before, up to the longest. */
public final class RetryPause {
    private final long first;
    private final long longest;
    private long next;

    /** In any unit of time, which {@link #next} then has. */
    public RetryPause(long first, long longest) {
        this.first = first;
        this.longest = longest;
        next = first;
    }

    public long next() {
        long pause = next;
        next = Math.min(2 * next, longest);
        return pause;
    }

    /** The next pause is the first one again. */
    public void reset() {
        next = first;
    }
}
