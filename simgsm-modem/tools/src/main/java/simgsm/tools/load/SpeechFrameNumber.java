package simgsm.tools.load;

/**
 * A number coded into a speech frame as two tones, each by its frequency and sign. The number survives A-law and GSM
 * 06.10, also in succession. Silence has no number.
 */
final class SpeechFrameNumber {
    /** No number: silence, or other speech. */
    static final int NONE = -1;

    private static final int TONES = 2;
    /**
     * 200 to 500 Hz and 550 to 850 Hz in steps of 50 Hz, orthogonal over 20 ms; GSM 06.10 keeps no signs of higher
     * ones.
     */
    private static final int FREQUENCIES = 7;

    private static final int FIRST_HERTZ = 200;
    private static final int STEP_HERTZ = 50;
    /** Each tone with both signs. */
    private static final int DIGITS = 2 * FREQUENCIES;

    /** The number of numbers, after which 0 follows: 196, or 3.92 s. */
    static final int COUNT = DIGITS * DIGITS;

    private static final int SAMPLES = 160;
    private static final int SAMPLES_PER_SECOND = 8_000;
    /** Table amplitude; sums of 160 products with samples fit into 32 bits. */
    private static final int AMPLITUDE = 64;

    private static final int LOUDNESS = 62;
    /** A tone below a quarter of its loudness is ignored. */
    private static final int LEAST = AMPLITUDE * AMPLITUDE * LOUDNESS * (SAMPLES / 2) / 4;

    private static final int[][] TABLE = new int[TONES * FREQUENCIES][SAMPLES];

    static {
        for (int tone = 0; tone < TABLE.length; tone++) {
            double step = 2 * Math.PI * (FIRST_HERTZ + STEP_HERTZ * tone) / SAMPLES_PER_SECOND;
            for (int i = 0; i < SAMPLES; i++) {
                TABLE[tone][i] = (int) Math.round(AMPLITUDE * Math.sin(step * (i + 0.5)));
            }
        }
    }

    private SpeechFrameNumber() {}

    static void put(short[] frame, int number) {
        int low = number % DIGITS;
        int high = number / DIGITS;
        int[] first = TABLE[low % FREQUENCIES];
        int[] second = TABLE[FREQUENCIES + high % FREQUENCIES];
        int firstLoudness = low < FREQUENCIES ? LOUDNESS : -LOUDNESS;
        int secondLoudness = high < FREQUENCIES ? LOUDNESS : -LOUDNESS;
        for (int i = 0; i < SAMPLES; i++) {
            frame[i] = (short) (first[i] * firstLoudness + second[i] * secondLoudness);
        }
    }

    /** Each tone is odd about the middle of the frame, so 80 products with the folded frame equal 160. */
    static int read(short[] frame) {
        int[] folded = new int[SAMPLES / 2];
        for (int i = 0; i < folded.length; i++) {
            folded[i] = frame[i] - frame[SAMPLES - 1 - i];
        }
        int low = digit(folded, 0);
        int high = digit(folded, FREQUENCIES);
        return low == NONE || high == NONE ? NONE : low + DIGITS * high;
    }

    private static int digit(int[] folded, int firstTone) {
        int strongest = 0;
        int digit = NONE;
        for (int i = 0; i < FREQUENCIES; i++) {
            int level = product(TABLE[firstTone + i], folded);
            if (Math.abs(level) > strongest) {
                strongest = Math.abs(level);
                digit = level > 0 ? i : FREQUENCIES + i;
            }
        }
        return strongest < LEAST ? NONE : digit;
    }

    private static int product(int[] tone, int[] folded) {
        int sum = 0;
        for (int i = 0; i < folded.length; i++) {
            sum += tone[i] * folded[i];
        }
        return sum;
    }
}
