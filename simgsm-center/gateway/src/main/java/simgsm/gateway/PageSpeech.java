package simgsm.gateway;

import java.util.ArrayDeque;
import simgsm.speech.SpeechCodec;
import simgsm.station.call.SpeechSource;

/**
 * The speech of a page on its way to the station. A page's timer is not exact, so its frames come in bursts; they leave
 * one every 20 ms behind a cushion. A frame that is late in a sound is replaced by the one before it, and after a longer
 * stall the rest of the sound is left out, for a hole would make two keys of one.
 */
final class PageSpeech implements SpeechSource {
    /** Frames that wait before the first one leaves: 40 ms. */
    static final int CUSHION_FRAMES = 2;

    /** 2 s, longer than a page stalls; the oldest frame beyond them is dropped. */
    static final int MOST_FRAMES = 100;

    /** A page that sends nothing for longer is silent. */
    static final int MOST_SUBSTITUTES = 5;

    /** The pause between two keys is at least so long after frames of it have been left out. */
    private static final int KEPT_SILENCE_FRAMES = 3;
    /** Largest sample of a silent frame: the smallest value of A-law. */
    private static final int SILENCE = 8;

    private final ArrayDeque<short[]> waiting = new ArrayDeque<>();
    private short[] last = new short[SpeechCodec.SAMPLES_PER_FRAME];
    private boolean isFilling = true;
    /** True after the page has stalled within a sound, until the rest of that sound has been left out. */
    private boolean isInterrupted;

    private int substitutes;
    private int silentFrames;

    /** @param frame 160 samples, kept */
    void accept(short[] frame) {
        if (waiting.size() == MOST_FRAMES) {
            waiting.removeFirst();
        }
        waiting.addLast(frame);
    }

    /** Forgets what waits: the call is over. */
    void clear() {
        waiting.clear();
        isFilling = true;
        isInterrupted = false;
        silentFrames = 0;
    }

    @Override
    public void read(short[] frame) {
        short[] next = next();
        silentFrames = isSilent(next) ? silentFrames + 1 : 0;
        System.arraycopy(next, 0, frame, 0, frame.length);
    }

    private short[] next() {
        while (isInterrupted && !waiting.isEmpty()) {
            isInterrupted = !isSilent(waiting.peekFirst());
            if (isInterrupted) {
                waiting.removeFirst();
            }
        }
        while (waiting.size() > CUSHION_FRAMES
                && silentFrames >= KEPT_SILENCE_FRAMES
                && isSilent(waiting.peekFirst())) {
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
            isInterrupted |= !isSilent(last);
            isFilling = true;
            last = new short[SpeechCodec.SAMPLES_PER_FRAME];
        }
        return last;
    }

    private static boolean isSilent(short[] frame) {
        for (short sample : frame) {
            if (Math.abs(sample) > SILENCE) {
                return false;
            }
        }
        return true;
    }
}
