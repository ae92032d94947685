package simgsm.net;

/** Pauses between attempts, each twice the one before, up to the longest. */
public final class RetryPause {
    private final long first;
    private final long longest;
    private long next;

    /** Both in any unit of time, which is that of {@link #next}. */
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

    /** Makes the first pause the next one. */
    public void reset() {
        next = first;
    }
}
