package simgsm.speech;

import java.util.Random;

/**
 * Decodes the frames of one direction of a call and substitutes lost ones by GSM 06.11 (TS 46.011, clause 5 and the
 * example of clause 6): the first lost frame repeats the last good one, each further one is 3 dB weaker (4 steps of
 * the block amplitude), and after 16 (320 ms) there is silence.
 *
 * <p>G.711 has no parameters; the last frame's samples are repeated and attenuated alike.
 */
public final class SubstitutingDecoder {
    /** Consecutive lost frames until silence. */
    private static final int FRAMES_TO_SILENCE = 16;
    /** Steps of block amplitude; 8 steps = 6 dB. */
    private static final int STEPS_PER_FRAME = 4;

    private static final double STEPS_PER_HALF = 8;
    private static final int GRID_POSITIONS = 4;

    private final SpeechCodec codec;
    /** Grid positions of attenuated frames are random, against a buzz of 50 Hz; the seed makes runs reproducible. */
    private final Random grids = new Random(0);
    /** Null before the first frame. */
    private byte[] lastGood;

    private int lostInRow;

    public SubstitutingDecoder(SpeechCodec.Kind kind) {
        codec = kind.open();
    }

    public SpeechCodec.Kind kind() {
        return codec.kind();
    }

    /** @param octets one frame, not changed afterwards; IllegalArgumentException for a wrong length */
    public short[] decode(byte[] octets) {
        short[] samples = codec.decode(octets);
        lastGood = octets;
        lostInRow = 0;
        return samples;
    }

    /** The substitute of one lost frame. */
    public short[] substitute() {
        lostInRow++;
        if (lastGood == null || lostInRow > FRAMES_TO_SILENCE) {
            return new short[SpeechCodec.SAMPLES_PER_FRAME];
        }
        int steps = STEPS_PER_FRAME * (lostInRow - 1);
        return codec.kind() == SpeechCodec.Kind.GSM_FULL_RATE ? weakenedParameters(steps) : weakenedSamples(steps);
    }

    private short[] weakenedParameters(int steps) {
        GsmFrame frame = new GsmFrame();
        frame.unpack(lastGood);
        for (int j = 0; steps > 0 && j < GsmFrame.SUBFRAMES; j++) {
            frame.largest[j] = Math.max(0, frame.largest[j] - steps);
            frame.grid[j] = grids.nextInt(GRID_POSITIONS);
        }
        return codec.decode(frame.pack());
    }

    private short[] weakenedSamples(int steps) {
        double factor = Math.pow(2, -steps / STEPS_PER_HALF);
        short[] samples = codec.decode(lastGood);
        for (int i = 0; i < samples.length; i++) {
            samples[i] = (short) Math.round(samples[i] * factor);
        }
        return samples;
    }
}
