package simgsm.cells.capture;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.LongStream;
import simgsm.cells.cipher.CipherKey;

/** Codes a block of 23 octets of a control channel into the bits of its bursts (TS 45.003, 4.1; TS 45.002, 5.2.3). */
final class BurstCoder {
    private static final int INFORMATION_BITS = 184;
    private static final int PARITY_BITS = 40;
    private static final long FIRE_POLYNOMIAL = 0x4820009L;
    private static final long PARITY_MASK = (1L << PARITY_BITS) - 1;
    /** With four tail bits. */
    private static final int UNCODED_BITS = INFORMATION_BITS + PARITY_BITS + 4;

    private static final int HALF_BURST = CipherKey.BURST_BITS / 2;
    private static final String[] TRAINING = {
        "00100101110000100010010111",
        "00101101110111100010110111",
        "01000011101110100100001110",
        "01000111101101000100011110",
        "00011010111001000001101011",
        "01001110101100000100111010",
        "10100111110110001010011111",
        "11101111000100101110111100"
    };

    private BurstCoder() {}

    /**
     * The bursts, ciphered. A fast associated channel takes halves of eight bursts; their speech is left out as zeros.
     *
     * @param frames of the bursts, four or eight
     * @param trainingSequence 0 to 7
     * @return 148 octets each, 0 or 1
     */
    static List<byte[]> bursts(byte[] block, long[] frames, int trainingSequence, CipherKey key, boolean isUplink) {
        byte[] coded = coded(block);
        byte[][] data = new byte[frames.length][CipherKey.BURST_BITS];
        for (int k = 0; k < coded.length; k++) {
            data[k % frames.length][2 * (49 * k % HALF_BURST) + k % 8 / 4] = coded[k];
        }
        List<byte[]> bursts = new ArrayList<>();
        for (int i = 0; i < frames.length; i++) {
            byte[] stream = key.stream(frames[i], isUplink);
            for (int bit = 0; bit < stream.length; bit++) {
                data[i][bit] ^= stream[bit];
            }
            boolean isSecondHalf = i >= 4;
            boolean isWhole = frames.length == 4;
            bursts.add(burst(data[i], isWhole || isSecondHalf, isWhole || !isSecondHalf, trainingSequence));
        }
        return bursts;
    }

    /** Tail, data, stealing flag, training sequence, stealing flag, data, tail. */
    private static byte[] burst(byte[] data, boolean isLowStolen, boolean isHighStolen, int trainingSequence) {
        byte[] bits = new byte[148];
        System.arraycopy(data, 0, bits, 3, HALF_BURST);
        bits[60] = (byte) (isLowStolen ? 1 : 0);
        for (int i = 0; i < 26; i++) {
            bits[61 + i] = (byte) (TRAINING[trainingSequence].charAt(i) - '0');
        }
        bits[87] = (byte) (isHighStolen ? 1 : 0);
        System.arraycopy(data, HALF_BURST, bits, 88, HALF_BURST);
        return bits;
    }

    /** 456 bits: the block, its parity by a Fire code, and both through a convolutional code of rate 1/2. */
    private static byte[] coded(byte[] block) {
        byte[] bits = new byte[UNCODED_BITS];
        long parity = 0;
        for (int i = 0; i < INFORMATION_BITS; i++) {
            bits[i] = (byte) (block[i / Byte.SIZE] >> i % Byte.SIZE & 1);
            boolean isSet = (parity >> PARITY_BITS - 1 & 1) != bits[i];
            parity = (parity << 1 ^ (isSet ? FIRE_POLYNOMIAL : 0)) & PARITY_MASK;
        }
        for (int i = 0; i < PARITY_BITS; i++) {
            bits[INFORMATION_BITS + i] = (byte) (~parity >> PARITY_BITS - 1 - i & 1);
        }
        byte[] coded = new byte[2 * UNCODED_BITS];
        for (int k = 0; k < UNCODED_BITS; k++) {
            int both = bits[k] ^ before(bits, k, 3) ^ before(bits, k, 4);
            coded[2 * k] = (byte) both;
            coded[2 * k + 1] = (byte) (both ^ before(bits, k, 1));
        }
        return coded;
    }

    private static int before(byte[] bits, int at, int distance) {
        return at < distance ? 0 : bits[at - distance];
    }

    /** The numbers of consecutive bursts. */
    static long[] frames(long first, int step, int count) {
        return LongStream.range(0, count).map(i -> first + step * i).toArray();
    }
}
