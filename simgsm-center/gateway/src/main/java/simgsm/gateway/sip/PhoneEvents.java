package simgsm.gateway.sip;

import java.util.function.Consumer;
import simgsm.dtmf.DtmfKey;

/**
 * Keys from telephone-event packets (RFC 4733): one for each source and time stamp, whatever is lost, repeated or
 * reordered; after its end a later packet with a shorter duration begins another key, because some phones use one time
 * stamp for all. Time is counted in frames of 20 ms.
 */
final class PhoneEvents {
    /** A key without packets ends after 100 ms. */
    private static final int MOST_SILENT_FRAMES = 5;
    /** A key that does not end counts as released after 10 s. */
    private static final int MOST_FRAMES = 500;

    private static final int EVENT_OCTETS = 4;
    private static final int END = 0x80;
    private static final int LONGEST_SEGMENT = 0xffff;
    private static final String KEYS = "0123456789*#ABCD";

    private final Consumer<DtmfKey> pressed;
    private final Runnable released;
    private boolean isHeard;
    private int source;
    private int timestamp;
    private int sequence;
    private int duration;
    private int event;
    private boolean isSounding;
    private int silentFrames;
    private int frames;

    PhoneEvents(Consumer<DtmfKey> pressed, Runnable released) {
        this.pressed = pressed;
        this.released = released;
    }

    /** True while a key is held. */
    boolean isSounding() {
        return isSounding;
    }

    void arrived(RtpHeader packet, byte[] payload) {
        int code = payload.length < EVENT_OCTETS ? KEYS.length() : payload[0] & 0xff;
        if (code >= KEYS.length()) {
            return;
        }
        boolean isEnd = (payload[1] & END) != 0;
        int ahead = isHeard && packet.source() == source ? packet.timestamp() - timestamp : 1;
        if (ahead < 0) {
            return;
        }
        boolean isLater = ahead > 0 || (short) (packet.sequence() - sequence) > 0;
        int before = duration;
        if (isLater) {
            sequence = packet.sequence();
            duration = (payload[2] & 0xff) << 8 | payload[3] & 0xff;
        }
        if (ahead > 0 || isLater && !isSounding && duration < before) {
            // RFC 4733, 2.5.1.3: a longer key goes on in a segment with another time stamp
            boolean isSegment = isHeard && code == event && ahead == LONGEST_SEGMENT && frames > 0;
            isHeard = true;
            source = packet.source();
            timestamp = packet.timestamp();
            if (!isSegment) {
                release();
                event = code;
                frames = 0;
                isSounding = true;
                pressed.accept(DtmfKey.of(KEYS.charAt(code)));
            }
        }
        silentFrames = 0;
        if (isEnd) {
            release();
        }
    }

    /** 20 ms have passed. */
    void framePassed() {
        if (isSounding && (++silentFrames > MOST_SILENT_FRAMES || ++frames > MOST_FRAMES)) {
            release();
        }
    }

    void release() {
        if (isSounding) {
            isSounding = false;
            released.run();
        }
    }
}
