package simgsm.dtmf;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;
import simgsm.tone.Sine;
import simgsm.tone.ToneLevel;

/**
 * Generates the tones of keys: a queue of keys of fixed length, and keys held down. Durations are exact in samples, a
 * tone is continuous from frame to frame, and tones are separated by silence. Owned by one thread.
 */
public final class DtmfGenerator {
    /** Least tone and pause of a key that is released at once (TS 23.014, 6). */
    private static final ToneShape SHORTEST_PRESS = ToneShape.STANDARD.withMillis(70, 65);

    static final int SAMPLES_PER_MILLI = 8;
    private static final long UNTIL_RELEASE = Long.MAX_VALUE;

    private final ToneShape shape;
    private final Consumer<DtmfKey> toneLeft;
    private final Deque<Press> queue = new ArrayDeque<>();
    private Press current;
    private Press held;

    /** @param toneLeft receives each key after the last sample of its tone, within {@code read} */
    public DtmfGenerator(ToneShape shape, Consumer<DtmfKey> toneLeft) {
        this.shape = shape;
        this.toneLeft = toneLeft;
    }

    public DtmfGenerator(Consumer<DtmfKey> toneLeft) {
        this(ToneShape.STANDARD, toneLeft);
    }

    public DtmfGenerator() {
        this(key -> {});
    }

    /** Appends a key of the generator's shape. */
    public void enqueue(DtmfKey key) {
        enqueue(key, shape);
    }

    public void enqueue(DtmfKey key, int toneMillis, int pauseMillis) {
        enqueue(key, shape.withMillis(toneMillis, pauseMillis));
    }

    public void enqueue(DtmfKey key, ToneShape itsShape) {
        queue.add(new Press(key, itsShape, (long) itsShape.toneMillis() * SAMPLES_PER_MILLI));
    }

    /** Presses a key: it sounds after the queued ones until {@link #release}. A pressed key is released before. */
    public void press(DtmfKey key) {
        release();
        held = new Press(
                key, shape.withMillis(SHORTEST_PRESS.toneMillis(), SHORTEST_PRESS.pauseMillis()), UNTIL_RELEASE);
        queue.add(held);
    }

    /** Releases the pressed key; no effect if there is none. */
    public void release() {
        if (held != null) {
            held.end();
            held = null;
        }
    }

    /** Drops the queue and the sounding key. @return number of keys not sent completely */
    public int drop() {
        int dropped = queue.size() + (current != null && !current.toneDone() ? 1 : 0);
        queue.clear();
        current = null;
        held = null;
        return dropped;
    }

    /** True if nothing sounds, nothing is queued, and the last pause is over. */
    public boolean isIdle() {
        return current == null && queue.isEmpty();
    }

    /** The key that sounds now, or null. */
    public DtmfKey sounding() {
        return current != null && !current.toneDone() ? current.key : null;
    }

    /** Fills the whole frame. @return true if any of it is a tone */
    public boolean read(short[] frame) {
        return read(frame, 0, frame.length);
    }

    /** Fills {@code samples[from..to)}. @return true if any of it is a tone */
    public boolean read(short[] samples, int from, int to) {
        boolean sound = false;
        for (int i = from; i < to; i++) {
            if (current == null) {
                current = queue.poll();
            }
            if (current == null) {
                samples[i] = 0;
                continue;
            }
            sound |= !current.isFaded();
            samples[i] = current.next();
            if (current.toneDone() && !current.isReported) {
                current.isReported = true;
                toneLeft.accept(current.key);
            }
            if (current != null && current.allDone()) {
                current = null;
            }
        }
        return sound;
    }

    /** One key being sent: its tone, then its pause. */
    private static final class Press {
        final DtmfKey key;
        private final ToneShape shape;
        private final Sine row;
        private final Sine column;
        private final int rampSamples;
        private long toneSamples;
        private long sent;
        private boolean isReported;

        Press(DtmfKey key, ToneShape shape, long toneSamples) {
            this.key = key;
            this.shape = shape;
            this.toneSamples = toneSamples;
            this.rampSamples = (int) Math.round(Math.min(shape.rampMillis(), shape.pauseMillis()) * SAMPLES_PER_MILLI);
            this.row = new Sine(key.rowHertz(), ToneLevel.amplitude(shape.rowDbm0()));
            this.column = new Sine(key.columnHertz(), ToneLevel.amplitude(shape.columnDbm0()));
        }

        void end() {
            toneSamples = Math.max(sent, (long) shape.toneMillis() * SAMPLES_PER_MILLI);
        }

        /** From here the tone only falls: its length counts at half amplitude. */
        boolean toneDone() {
            return sent >= toneSamples;
        }

        boolean isFaded() {
            return sent - rampSamples >= toneSamples;
        }

        boolean allDone() {
            return sent - (long) shape.pauseMillis() * SAMPLES_PER_MILLI >= toneSamples;
        }

        short next() {
            double value = isFaded() ? 0 : envelope() * (row.next() + column.next());
            sent++;
            return (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, Math.rint(value)));
        }

        private double envelope() {
            long fromEdge = Math.min(sent, toneSamples - 1 + rampSamples - sent);
            return fromEdge >= rampSamples ? 1 : 0.5 - 0.5 * Math.cos(Math.PI * (fromEdge + 0.5) / rampSamples);
        }
    }
}
