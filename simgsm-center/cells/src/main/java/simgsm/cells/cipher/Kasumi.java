package simgsm.cells.cipher;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** KASUMI, a block cipher of 64 bits with a key of 128 bits (TS 35.202). */
final class Kasumi {
    private static final int ROUNDS = 8;
    private static final int HALF = 0xffff;
    private static final int[] CONSTANTS = {0x0123, 0x4567, 0x89ab, 0xcdef, 0xfedc, 0xba98, 0x7654, 0x3210};
    private static final int SMALL_BOX = 128;
    /** S7 with 128 values, then S9 with 512. */
    private static final int[] BOXES = boxes();

    private final int[] key = new int[ROUNDS];
    /** The key with the constants. */
    private final int[] changed = new int[ROUNDS];

    /** @param key 16 octets */
    Kasumi(byte[] key) {
        for (int i = 0; i < ROUNDS; i++) {
            this.key[i] = (key[2 * i] & 0xff) << Byte.SIZE | key[2 * i + 1] & 0xff;
            changed[i] = this.key[i] ^ CONSTANTS[i];
        }
    }

    private static int[] boxes() {
        try (InputStream in = Kasumi.class.getResourceAsStream("kasumi.txt")) {
            String text = new String(in.readAllBytes(), StandardCharsets.US_ASCII);
            return Arrays.stream(text.strip().split("[\\s,]+"))
                    .mapToInt(Integer::parseInt)
                    .toArray();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    long encrypt(long block) {
        int left = (int) (block >>> Integer.SIZE);
        int right = (int) block;
        for (int round = 0; round < ROUNDS; round += 2) {
            right ^= mixed(limited(left, round), round);
            left ^= limited(mixed(right, round + 1), round + 1);
        }
        return (long) left << Integer.SIZE | right & 0xffffffffL;
    }

    private int key(int round, int ahead, int rotation) {
        return rotated(key[(round + ahead) % ROUNDS], rotation);
    }

    private int changed(int round, int ahead) {
        return changed[(round + ahead) % ROUNDS];
    }

    private static int rotated(int half, int by) {
        return (half << by | half >>> Short.SIZE - by) & HALF;
    }

    /** FL. */
    private int limited(int word, int round) {
        int left = word >>> Short.SIZE;
        int right = word & HALF;
        right ^= rotated(left & key(round, 0, 1), 1);
        left ^= rotated(right | changed(round, 2), 1);
        return left << Short.SIZE | right;
    }

    /** FO. */
    private int mixed(int word, int round) {
        int left = word >>> Short.SIZE;
        int right = word & HALF;
        left = substituted(left ^ key(round, 1, 5), changed(round, 4)) ^ right;
        right = substituted(right ^ key(round, 5, 8), changed(round, 3)) ^ left;
        left = substituted(left ^ key(round, 6, 13), changed(round, 7)) ^ right;
        return right << Short.SIZE | left;
    }

    /** FI. */
    private static int substituted(int half, int subkey) {
        int nine = half >> 7;
        int seven = half & 0x7f;
        nine = BOXES[SMALL_BOX + nine] ^ seven;
        seven = BOXES[seven] ^ nine & 0x7f;
        seven ^= subkey >> 9;
        nine ^= subkey & 0x1ff;
        nine = BOXES[SMALL_BOX + nine] ^ seven;
        seven = BOXES[seven] ^ nine & 0x7f;
        return seven << 9 | nine;
    }
}
