package simgsm.phone.handset;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;

/** The keys on their way out: runs of keys of 100 ms and keys that are held, each run told once its last tone has left. */
final class KeySender {
    private final DtmfGenerator generator = new DtmfGenerator(this::toneLeft);
    private final Deque<Run> runs = new ArrayDeque<>();
    private final Consumer<String> sent;

    /** @param sent told the keys of each run when its last tone has left */
    KeySender(Consumer<String> sent) {
        this.sent = sent;
    }

    void press(List<DtmfKey> keys) {
        StringBuilder symbols = new StringBuilder();
        for (DtmfKey key : keys) {
            generator.enqueue(key);
            symbols.append(key.symbol());
        }
        runs.add(new Run(symbols.toString()));
    }

    /** Down goes a key, to sound until {@link #up}. */
    void down(DtmfKey key) {
        generator.press(key);
        runs.add(new Run(String.valueOf(key.symbol())));
    }

    void up() {
        generator.release();
    }

    void read(short[] frame) {
        generator.read(frame);
    }

    /** Forgets what has not left. */
    void drop() {
        generator.drop();
        runs.clear();
    }

    /** Whether all tones have left. */
    boolean isIdle() {
        return runs.isEmpty();
    }

    /** The key that sounds now, or null. */
    DtmfKey sounding() {
        return generator.sounding();
    }

    private void toneLeft(DtmfKey key) {
        Run run = runs.peek();
        if (run != null && ++run.left == run.keys.length()) {
            runs.remove();
            sent.accept(run.keys);
        }
    }

    private static final class Run {
        final String keys;
        int left;

        Run(String keys) {
            this.keys = keys;
        }
    }
}
