package simgsm.gateway.speech;

import java.util.ArrayDeque;
import simgsm.speech.SpeechCodec;
import simgsm.station.call.SpeechSource;

/**
 * Buffers the speech of a page or a SIP phone for the station. Its frames arrive in bursts; a cushion
 * releases one every 20 ms. The last frame replaces one that is late in a sound; after a longer stall the rest of the
 * sound is dropped, because a gap would split one key into two.
 */
public final class SpeechBuffer implements SpeechSource {
    /** Number of frames before the first one is released: 40 ms. */
    static final int CUSHION_FRAMES = 2;

    /** 5 s, longer than a browser or this machine stalls; the oldest frame above this is dropped. */
    static final int MOST_FRAMES = 250;

    /** Maximum of substitutes; after them the sender counts as silent. */
    static final int MOST_SUBSTITUTES = 5;

    /** Minimum pause between two keys after frames of it were dropped. */
    private static final int KEPT_SILENCE_FRAMES = 3;
    /** Largest sample of a silent frame: the smallest value of A-law. */
    private static final int SILENCE = 8;

    private final ArrayDeque<short[]> waiting = new ArrayDeque<>();
    private short[] last = new short[SpeechCodec.SAMPLES_PER_FRAME];
    private boolean isFilling = true;
    /** True after a stall within a sound, until the rest of that sound has been dropped. */
    private boolean isInterrupted;

    private int substitutes;
    private int silentFrames;
    private int dropped;

    /**
     * Adds a frame.
     *
     * @param frame 160 samples, kept
     */
    public void accept(short[] frame) {
        if (waiting.size() == MOST_FRAMES) {
            waiting.removeFirst();
            dropped++;
        }
        waiting.addLast(frame);
    }

    /** Empties the buffer at the end of the call. */
    public void clear() {
        waiting.clear();
        isFilling = true;
        isInterrupted = false;
        silentFrames = 0;
        dropped = 0;
    }

    @Override
    public int framesDropped() {
        int frames = dropped;
        dropped = 0;
        return frames;
    }

    @Override
    public void read(short[] frame) {
        short[] next = next();
        silentFrames = SpeechCodec.isSilent(next, SILENCE) ? silentFrames + 1 : 0;
        System.arraycopy(next, 0, frame, 0, frame.length);
    }

    private short[] next() {
        while (isInterrupted && !waiting.isEmpty()) {
            isInterrupted = !SpeechCodec.isSilent(waiting.peekFirst(), SILENCE);
            if (isInterrupted) {
                waiting.removeFirst();
            }
        }
        while (waiting.size() > CUSHION_FRAMES
                && silentFrames >= KEPT_SILENCE_FRAMES
                && SpeechCodec.isSilent(waiting.peekFirst(), SILENCE)) {
            waiting.removeFirst();
        }
        if (waiting.isEmpty() || isFilling && waiting.size() < CUSHION_FRAMES) {
            return substitute();
        }
        isFilling = false;
        substitutes = 0;
        last = waiting.removeFirst();
        return last;
    }

    private short[] substitute() {
        if (!isFilling && substitutes < MOST_SUBSTITUTES) {
            substitutes++;
        } else {
            isInterrupted |= !SpeechCodec.isSilent(last, SILENCE);
            isFilling = true;
            last = new short[SpeechCodec.SAMPLES_PER_FRAME];
        }
        return last;
    }
}
