package simgsm.speech;

/** LAR, the coded form of the short-term filter (ETS 300 961, 5.2.4 to 5.2.9). */
final class LogAreaRatios {
    static final int ORDER = 8;
    /** First sample of each part of the frame with its own filter (table 3.2). */
    static final int[] PART_STARTS = {0, 13, 27, 40, 160};

    private static final int[] A = {20480, 20480, 20480, 20480, 13964, 15360, 8534, 9036};
    private static final int[] B = {0, 0, 2048, -2560, 94, -1792, -341, -1144};
    private static final int[] LEAST = {-32, -32, -16, -16, -8, -8, -4, -4};
    private static final int[] MOST = {31, 31, 15, 15, 7, 7, 3, 3};
    private static final int[] INVERSE_A = {13107, 13107, 13107, 13107, 19223, 17476, 31454, 29708};

    private LogAreaRatios() {}

    /** Codes a frame's samples. Scales them in place and back, which clears the lowest bits of loud frames (5.2.4). */
    static void code(int[] samples, int[] codes) {
        int[] reflection = reflection(correlate(samples));
        for (int i = 0; i < ORDER; i++) {
            int ratio = FixedPoint.multiply(A[i], toRatio(reflection[i]));
            ratio = FixedPoint.add(FixedPoint.add(ratio, B[i]), 256) >> 9;
            codes[i] = Math.max(LEAST[i], Math.min(MOST[i], ratio)) - LEAST[i];
        }
    }

    private static int[] correlate(int[] samples) {
        int peak = 0;
        for (int sample : samples) {
            peak = Math.max(peak, FixedPoint.absolute(sample));
        }
        int scale = peak == 0 ? 0 : 4 - FixedPoint.headroom(peak << 16);
        if (scale > 0) {
            int factor = 16384 >> scale - 1;
            for (int k = 0; k < samples.length; k++) {
                samples[k] = FixedPoint.multiplyRounded(samples[k], factor);
            }
        }
        int[] sums = new int[ORDER + 1];
        for (int k = 0; k <= ORDER; k++) {
            int sum = 0;
            for (int i = k; i < samples.length; i++) {
                sum += samples[i] * samples[i - k];
            }
            sums[k] = sum << 1;
        }
        if (scale > 0) {
            for (int k = 0; k < samples.length; k++) {
                samples[k] = (short) (samples[k] << scale);
            }
        }
        return sums;
    }

    /** Reflection coefficients by Schur's recursion (5.2.5). */
    private static int[] reflection(int[] sums) {
        int[] result = new int[ORDER];
        if (sums[0] == 0) {
            return result;
        }
        int shift = FixedPoint.headroom(sums[0]);
        int[] p = new int[ORDER + 1];
        int[] k = new int[ORDER + 1];
        for (int i = 0; i <= ORDER; i++) {
            p[i] = sums[i] << shift >> 16;
            k[i] = p[i];
        }
        for (int n = 0; n < ORDER; n++) {
            int size = FixedPoint.absolute(p[1]);
            if (p[0] < size) {
                break;
            }
            int r = FixedPoint.divide(size, p[0]);
            r = p[1] > 0 ? -r : r;
            result[n] = r;
            p[0] = FixedPoint.add(p[0], FixedPoint.multiplyRounded(p[1], r));
            for (int m = 1; m < ORDER - n; m++) {
                int next = p[m + 1];
                p[m] = FixedPoint.add(next, FixedPoint.multiplyRounded(k[m], r));
                k[m] = FixedPoint.add(k[m], FixedPoint.multiplyRounded(next, r));
            }
        }
        return result;
    }

    private static int toRatio(int reflection) {
        int size = FixedPoint.absolute(reflection);
        if (size < 22118) {
            size >>= 1;
        } else if (size < 31130) {
            size -= 11059;
        } else {
            size = size - 26112 << 2;
        }
        return reflection < 0 ? -size : size;
    }

    /** Decoded ratios (5.2.8). */
    static void decode(int[] codes, int[] ratios) {
        for (int i = 0; i < ORDER; i++) {
            int scaled = FixedPoint.subtract(codes[i] + LEAST[i] << 10, B[i] << 1);
            int ratio = FixedPoint.multiplyRounded(INVERSE_A[i], scaled);
            ratios[i] = FixedPoint.add(ratio, ratio);
        }
    }

    /** Reflection coefficients for one part of the frame, between the last frame's ratios and this one's (5.2.9). */
    static void between(int[] before, int[] now, int part, int[] reflection) {
        for (int i = 0; i < ORDER; i++) {
            int ratio = switch (part) {
                case 0 -> FixedPoint.add(FixedPoint.add(before[i] >> 2, now[i] >> 2), before[i] >> 1);
                case 1 -> FixedPoint.add(before[i] >> 1, now[i] >> 1);
                case 2 -> FixedPoint.add(FixedPoint.add(before[i] >> 2, now[i] >> 2), now[i] >> 1);
                default -> now[i];
            };
            reflection[i] = toReflection(ratio);
        }
    }

    private static int toReflection(int ratio) {
        int size = FixedPoint.absolute(ratio);
        if (size < 11059) {
            size <<= 1;
        } else if (size < 20070) {
            size += 11059;
        } else {
            size = FixedPoint.add(size >> 2, 26112);
        }
        return ratio < 0 ? -size : size;
    }
}
