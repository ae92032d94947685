package simgsm.speech;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.function.Consumer;

/**
 * Interleaves both directions of a call: left sent, right received. The sent frames set the time; received frames
 * that are late or bursty are continuous if at most 200 ms late.
 */
final class CallInterleaver {
    /** Longest delay of a received frame in frames of 20 ms; then silence replaces it. */
    static final int LONGEST_LAG_FRAMES = 10;
    /** Longest lead of received frames over sent ones; then silence is added as sent. */
    static final int LONGEST_LEAD_FRAMES = 25;
    /** Frames in a block: 200 ms. */
    private static final int BLOCK_FRAMES = 10;

    private static final short[] SILENCE = new short[SpeechCodec.SAMPLES_PER_FRAME];

    private final Consumer<short[]> blocks;
    private final Deque<short[]> left = new ArrayDeque<>();
    private final Deque<short[]> right = new ArrayDeque<>();
    private boolean hasReceived;
    private short[] block = new short[2 * BLOCK_FRAMES * SpeechCodec.SAMPLES_PER_FRAME];
    private int fill;

    /** @param blocks receives the samples, left and right alternating */
    CallInterleaver(Consumer<short[]> blocks) {
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
        while (!hasReceived && right.size() + 1 < left.size()) {
            right.add(SILENCE);
        }
        hasReceived = true;
        right.add(frame);
        if (right.size() > LONGEST_LEAD_FRAMES) {
            left.add(SILENCE);
        }
        drain();
    }

    /** Ends the call and outputs the rest. */
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
        hasReceived = false;
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
