package simgsm.cells.cipher;

import java.nio.ByteBuffer;

/** The key stream of A5/3: KASUMI in the mode KGCORE (TS 55.216, 5). */
final class A53 {
    private static final long KEY_MODIFIER = 0x5555555555555555L;
    /** CA, which makes the streams of different uses of KGCORE different. */
    private static final long USE = 0x0fL << 16;

    private A53() {}

    /** The first bits of the stream. @param kc 64 bits; @param count the 22 bits of the frame's number as T1, T3 and T2 */
    static byte[] stream(byte[] kc, int count, int length) {
        long key = ByteBuffer.wrap(kc).getLong();
        Kasumi cipher = new Kasumi(doubled(key));
        long start = new Kasumi(doubled(key ^ KEY_MODIFIER)).encrypt((long) count << Integer.SIZE | USE);
        byte[] bits = new byte[length];
        long block = 0;
        for (int i = 0; i < length; i++) {
            if (i % Long.SIZE == 0) {
                block = cipher.encrypt(start ^ i / Long.SIZE ^ block);
            }
            bits[i] = (byte) (block >>> Long.SIZE - 1 - i % Long.SIZE & 1);
        }
        return bits;
    }

    private static byte[] doubled(long key) {
        return ByteBuffer.allocate(2 * Long.BYTES).putLong(key).putLong(key).array();
    }
}
