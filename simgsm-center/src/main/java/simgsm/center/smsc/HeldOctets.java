package simgsm.center.smsc;

/**
 * The octets of heap that messages and reports hold, and the limit for them: what a heap accepts, the same heap restores
 * after a restart. An envelope counts from the submission, before it is stored, until it has left its queue.
 */
final class HeldOctets {
    /**
     * Octets of an envelope in queue, register, timers and journal, besides its SUBMIT: 860 measured, with addresses that
     * it shares with no other (docs/MEASURED.md).
     */
    static final int ENVELOPE = 900;

    /** Of an application's message, for its place among those from the same source to the same receiver. */
    private static final int SENT = 100;

    /** Usable share of the heap: the collector needs the rest, and the serial one gives long-lived objects two thirds. */
    private static final double SHARE = 0.6;

    /** The program itself, and messages that are kept after their end to recognise repetitions. */
    private static final long RESERVED = 24 << 20;

    /** Octets of a remembered attempt. */
    private static final int ATTEMPT = 72;

    /** Further refusals are not logged above this share of the octets held at the first. */
    private static final double QUIET = 0.9;

    private final long most;
    private long held;
    /** Octets held at the first refusal; 0 if nothing is refused. */
    private long refusedAt;

    /** @param most above it nothing is accepted */
    HeldOctets(long most) {
        this.most = most;
    }

    /** With the limit for a heap of this size. */
    static HeldOctets in(long heapOctets) {
        return new HeldOctets(Math.max(0, (long) (SHARE * heapOctets) - RESERVED));
    }

    static long of(ShortMessage message) {
        return ENVELOPE + message.submit().length() + (message.esme().isPresent() ? SENT : 0);
    }

    boolean hasRoomFor(long octets) {
        return held + octets <= most;
    }

    void attempted(int further) {
        held += (long) ATTEMPT * further;
    }

    void add(ShortMessage message) {
        held += of(message);
    }

    void remove(ShortMessage message) {
        held -= of(message);
        refusedAt = held > refusedAt * QUIET ? refusedAt : 0;
    }

    /** True for the first refusal, and for the first after a tenth of the octets has left. */
    boolean isNewlyRefusing() {
        boolean isNew = refusedAt == 0;
        refusedAt = isNew ? Math.max(1, held) : refusedAt;
        return isNew;
    }

    long most() {
        return most;
    }

    long held() {
        return held;
    }
}
