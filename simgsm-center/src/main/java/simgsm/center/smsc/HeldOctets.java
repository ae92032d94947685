package simgsm.center.smsc;

/**
 * The octets of heap used by messages and reports, and their limit: a restart with the same heap can restore all
 * accepted messages. An envelope counts from the submission, before it is stored, until its removal from its queue.
 */
final class HeldOctets {
    /**
     * Octets of an envelope in queue, register, timers and journal, besides its SUBMIT: 860 measured, with unshared
     * addresses (docs/MEASURED.md).
     */
    static final int ENVELOPE = 900;

    /** Octets of an application's message for its index by source and receiver. */
    private static final int SENT = 100;

    /**
     * Usable share of the heap: the collector needs the rest, and the serial one gives long-lived objects two thirds.
     */
    private static final double SHARE = 0.6;

    /** Octets of the program itself, and of ended messages kept to recognise repetitions. */
    private static final long RESERVED = 24 << 20;

    /** Octets of a stored attempt. */
    private static final int ATTEMPT = 72;

    /** Share of the octets held at the first refusal below which refusals are logged again. */
    private static final double QUIET = 0.9;

    private final long most;
    private long held;
    /** Octets held at the first refusal; 0 if nothing is refused. */
    private long refusedAt;

    /** @param most limit of acceptance */
    HeldOctets(long most) {
        this.most = most;
    }

    /** Creates the limit for a heap of this size. */
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

    /** True for the first refusal, and for the first after a tenth of the octets was freed. */
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
