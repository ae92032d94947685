package simgsm.phone.handset;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;

/** Sends keys as tones in the phone's speech: runs of keys of 100 ms, and held keys. */
class KeySender {
    private static final class Run {
        final String keys;
        final Runnable whenSent;
        int sent;

        Run(String keys, Runnable whenSent) {
            this.keys = keys;
            this.whenSent = whenSent;
        }
    }

    private static final int PAUSE_MILLIS = 100;

    private final Deque<Run> runs = new ArrayDeque<>();
    private final Consumer<String> runSent;
    /** The sent sound, or a sidetone. */
    final DtmfGenerator generator;

    /** @param runSent receives the keys of each run when its last tone has been sent */
    KeySender(Consumer<String> runSent) {
        this.runSent = runSent;
        generator = new DtmfGenerator(this::toneGenerated);
    }

    /** @param whenSent runs when the last tone has been sent */
    void press(List<DtmfKey> keys, int toneMillis, Runnable whenSent) {
        String symbols = keys.stream().map(key -> String.valueOf(key.symbol())).collect(Collectors.joining());
        runs.add(new Run(symbols, whenSent));
        keys.forEach(key -> enqueue(key, toneMillis));
    }

    /** Starts a key's tone, which lasts until {@link #up}. */
    void down(DtmfKey key) {
        runs.add(new Run(String.valueOf(key.symbol()), () -> {}));
        hold(key);
    }

    void up() {
        generator.release();
    }

    /**
     * Fills the next 20 ms.
     *
     * @param speech for the far end
     * @param heard for the earpiece
     */
    void read(short[] speech, short[] heard) {
        generator.read(speech);
        System.arraycopy(speech, 0, heard, 0, speech.length);
    }

    /** Drops unsent keys. @return them */
    String drop() {
        String rest = runs.stream().map(run -> run.keys.substring(run.sent)).collect(Collectors.joining());
        generator.drop();
        runs.clear();
        return rest;
    }

    boolean isIdle() {
        return runs.isEmpty();
    }

    /** The key that sounds now, or null. */
    DtmfKey sounding() {
        return generator.sounding();
    }

    void enqueue(DtmfKey key, int toneMillis) {
        generator.enqueue(key, toneMillis, PAUSE_MILLIS);
    }

    void hold(DtmfKey key) {
        generator.press(key);
    }

    void toneGenerated(DtmfKey key) {
        toneSent();
    }

    final void toneSent() {
        Run run = runs.peek();
        if (run != null && ++run.sent == run.keys.length()) {
            runs.remove();
            runSent.accept(run.keys);
            run.whenSent.run();
        }
    }
}
