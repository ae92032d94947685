package simgsm.phone.handset;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import simgsm.dtmf.DtmfKey;

/** The keys on their way out: runs of keys of 100 ms and keys that are held, each run told once its last tone has left. */
final class KeySender {
    private final Deque<Run> runs = new ArrayDeque<>();
    private final Consumer<String> sent;
    private KeyWay way = new InBandKeys(this::toneLeft);

    /** @param sent told the keys of each run when its last tone has left */
    KeySender(Consumer<String> sent) {
        this.sent = sent;
    }

    /** Instead of by sound the keys go another way, which tells {@link #toneLeft}; before anything else. */
    void goBy(KeyWay otherWay) {
        way = otherWay;
    }

    void press(List<DtmfKey> keys) {
        StringBuilder symbols = new StringBuilder();
        keys.forEach(key -> symbols.append(key.symbol()));
        runs.add(new Run(symbols.toString()));
        keys.forEach(way::enqueue);
    }

    /** Down goes a key, to sound until {@link #up}. */
    void down(DtmfKey key) {
        runs.add(new Run(String.valueOf(key.symbol())));
        way.press(key);
    }

    void up() {
        way.release();
    }

    /** The next 20 ms, as said to the far end and as heard here. */
    void read(short[] said, short[] heard) {
        way.read(said, heard);
    }

    /** Forgets what has not left. @return it */
    String drop() {
        String rest = runs.stream().map(run -> run.keys.substring(run.left)).collect(Collectors.joining());
        way.drop();
        runs.clear();
        return rest;
    }

    /** Whether all tones have left. */
    boolean isIdle() {
        return runs.isEmpty();
    }

    /** The key that sounds now, or null. */
    DtmfKey sounding() {
        return way.sounding();
    }

    void toneLeft(DtmfKey key) {
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
