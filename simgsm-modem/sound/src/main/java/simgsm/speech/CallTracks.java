package simgsm.speech;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.function.Consumer;

/**
 * A call's two directions laid side by side: left what was sent, right what was received. What was sent keeps the time;
 * what is received late or in bursts is still put without a hole, as long as it comes within 200 ms.
 */
final class CallTracks {
    /** More than this is not waited for: silence stands for it. */
    static final int LONGEST_LAG_FRAMES = 10;
    /** So much may come ahead of what is sent, after the sender's own pause. */
    static final int LONGEST_LEAD_FRAMES = 25;
    /** 200 ms of both tracks are handed on at a time. */
    private static final int BLOCK_FRAMES = 10;

    private static final short[] SILENCE = new short[SpeechCodec.SAMPLES_PER_FRAME];

    private final Consumer<short[]> blocks;
    private final Deque<short[]> left = new ArrayDeque<>();
    private final Deque<short[]> right = new ArrayDeque<>();
    private boolean heard;
    private short[] block = new short[2 * BLOCK_FRAMES * SpeechCodec.SAMPLES_PER_FRAME];
    private int fill;

    /** @param blocks given the samples of both, left and right in turn */
    CallTracks(Consumer<short[]> blocks) {
        this.blocks = blocks;
    }

    void sent(short[] frame) {
        left.add(frame);
        if (left.size() > LONGEST_LAG_FRAMES) {
            right.add(SILENCE);
        }
        drain();
    }

    void received(short[] frame) {
        while (!heard && right.size() + 1 < left.size()) {
            right.add(SILENCE);
        }
        heard = true;
        right.add(frame);
        if (right.size() > LONGEST_LEAD_FRAMES) {
            left.add(SILENCE);
        }
        drain();
    }

    /** The call is over: hands on the rest. */
    void end() {
        while (left.size() < right.size()) {
            left.add(SILENCE);
        }
        while (right.size() < left.size()) {
            right.add(SILENCE);
        }
        drain();
        if (fill > 0) {
            blocks.accept(Arrays.copyOf(block, fill));
            fill = 0;
        }
        heard = false;
    }

    private void drain() {
        while (!left.isEmpty() && !right.isEmpty()) {
            interleave(left.remove(), right.remove());
        }
    }

    private void interleave(short[] ofLeft, short[] ofRight) {
        for (int i = 0; i < SpeechCodec.SAMPLES_PER_FRAME; i++) {
            block[fill++] = ofLeft[i];
            block[fill++] = ofRight[i];
        }
        if (fill == block.length) {
            blocks.accept(block);
            block = new short[block.length];
            fill = 0;
        }
    }
}
