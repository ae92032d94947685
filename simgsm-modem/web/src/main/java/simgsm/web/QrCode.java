package simgsm.web;

import java.nio.charset.StandardCharsets;
import java.util.function.IntPredicate;

/**
 * A QR code (ISO/IEC 18004) of a text of up to 106 octets: byte mode, versions 1 to 5, error correction level L, one
 * block.
 */
public final class QrCode {
    /** Light modules around a code (5.3.8). */
    public static final int QUIET_ZONE = 4;

    private static final int[] DATA_CODEWORDS = {19, 34, 55, 80, 108};
    private static final int[] CHECK_CODEWORDS = {7, 10, 15, 20, 26};
    private static final int MASKS = 8;
    /** Penalties of table 11. */
    private static final int[] PENALTY = {3, 3, 40, 10};

    private static final String FINDER_LIKE = "10111010000";

    private final int size;
    private final boolean[][] isDark;
    /** Modules without data: patterns and format information. */
    private final boolean[][] isFixed;

    /** @throws IllegalArgumentException for a text of more than 106 octets in UTF-8 */
    public QrCode(String text) {
        byte[] octets = text.getBytes(StandardCharsets.UTF_8);
        int version = 1;
        while (version <= DATA_CODEWORDS.length && octets.length + 2 > DATA_CODEWORDS[version - 1]) {
            version++;
        }
        if (version > DATA_CODEWORDS.length) {
            throw new IllegalArgumentException("expected at most 106 octets, found " + octets.length);
        }
        size = 17 + 4 * version;
        isDark = new boolean[size][size];
        isFixed = new boolean[size][size];
        placePatterns(version);
        placeData(codewords(octets, DATA_CODEWORDS[version - 1], CHECK_CODEWORDS[version - 1]));
        mask(bestMask());
    }

    /** Modules on each side, without the quiet zone. */
    public int size() {
        return size;
    }

    public boolean isDark(int column, int row) {
        return isDark[row][column];
    }

    /** The path of the dark modules in SVG, one unit per module, with the quiet zone's corner as origin. */
    public String svgPath() {
        StringBuilder path = new StringBuilder();
        for (int row = 0; row < size; row++) {
            for (int column = 0; column < size; column++) {
                if (isDark[row][column]) {
                    path.append('M')
                            .append(column + QUIET_ZONE)
                            .append(' ')
                            .append(row + QUIET_ZONE)
                            .append("h1v1h-1z");
                }
            }
        }
        return path.toString();
    }

    /** Data (7.4), then check codewords (7.5). */
    private static byte[] codewords(byte[] octets, int dataCount, int checkCount) {
        byte[] all = new byte[dataCount + checkCount];
        // Mode 0100 and the length have 12 bits, so every octet is split in two.
        all[0] = (byte) (0x40 | octets.length >> 4);
        all[1] = (byte) (octets.length << 4);
        for (int i = 0; i < octets.length; i++) {
            all[i + 1] |= (byte) ((octets[i] & 0xff) >> 4);
            all[i + 2] = (byte) (octets[i] << 4);
        }
        for (int i = octets.length + 2, pad = 0xec; i < dataCount; i++, pad ^= 0xec ^ 0x11) {
            all[i] = (byte) pad;
        }
        byte[] rest = all.clone();
        int[] generator = generator(checkCount);
        for (int i = 0; i < dataCount; i++) {
            int factor = rest[i] & 0xff;
            for (int j = 0; j <= checkCount; j++) {
                rest[i + j] ^= (byte) product(generator[j], factor);
            }
        }
        System.arraycopy(rest, dataCount, all, dataCount, checkCount);
        return all;
    }

    /** The product of (x - 2^i) for i below the degree, the highest power first. */
    private static int[] generator(int degree) {
        int[] polynomial = new int[degree + 1];
        polynomial[0] = 1;
        int root = 1;
        for (int i = 1; i <= degree; i++) {
            for (int j = i; j > 0; j--) {
                polynomial[j] ^= product(polynomial[j - 1], root);
            }
            root = product(root, 2);
        }
        return polynomial;
    }

    /** The product in GF(256) modulo x^8 + x^4 + x^3 + x^2 + 1. */
    private static int product(int x, int y) {
        int product = 0;
        for (int bit = 7; bit >= 0; bit--) {
            product = product << 1 ^ (product >> 7) * 0x11d;
            product ^= (y >> bit & 1) * x;
        }
        return product;
    }

    private void fix(int column, int row, boolean dark) {
        if (column >= 0 && column < size && row >= 0 && row < size) {
            isDark[row][column] = dark;
            isFixed[row][column] = true;
        }
    }

    private void placePatterns(int version) {
        for (int i = 8; i < size - 8; i++) {
            fix(i, 6, i % 2 == 0);
            fix(6, i, i % 2 == 0);
        }
        placeRings(3, 3, 4);
        placeRings(size - 4, 3, 4);
        placeRings(3, size - 4, 4);
        if (version > 1) {
            placeRings(size - 7, size - 7, 2);
        }
        placeFormat(0);
    }

    /** A finder pattern with its separator (radius 4), or an alignment pattern (radius 2). */
    private void placeRings(int column, int row, int radius) {
        for (int down = -radius; down <= radius; down++) {
            for (int right = -radius; right <= radius; right++) {
                int ring = Math.max(Math.abs(down), Math.abs(right));
                fix(column + right, row + down, radius == 4 ? ring != 2 && ring != 4 : ring != 1);
            }
        }
    }

    /** Level L and the mask, twice (7.9). */
    private void placeFormat(int mask) {
        int data = 1 << 3 | mask;
        int rest = data;
        for (int i = 0; i < 10; i++) {
            rest = rest << 1 ^ (rest >> 9) * 0x537;
        }
        int bits = (data << 10 | rest) ^ 0x5412;
        for (int i = 0; i < 15; i++) {
            boolean dark = (bits >> i & 1) != 0;
            fix(i < 8 ? size - 1 - i : i == 8 ? 7 : 14 - i, 8, dark);
            fix(8, i < 6 ? i : i < 8 ? i + 1 : size - 15 + i, dark);
        }
        fix(8, size - 8, true);
    }

    /** Fills pairs of columns from the right, up and down in turn (7.7.3). */
    private void placeData(byte[] codewords) {
        int bit = 0;
        for (int right = size - 1; right > 0; right -= 2) {
            right -= right == 6 ? 1 : 0;
            for (int step = 0; step < size; step++) {
                int row = (right + 1 & 2) == 0 ? size - 1 - step : step;
                for (int column = right; column >= right - 1; column--) {
                    if (!isFixed[row][column] && bit < codewords.length * 8) {
                        isDark[row][column] = (codewords[bit / 8] >> 7 - bit % 8 & 1) != 0;
                        bit++;
                    }
                }
            }
        }
    }

    private int bestMask() {
        int best = 0;
        int least = Integer.MAX_VALUE;
        for (int mask = 0; mask < MASKS; mask++) {
            mask(mask);
            int penalty = penalty();
            mask(mask);
            if (penalty < least) {
                least = penalty;
                best = mask;
            }
        }
        return best;
    }

    /** Inverts the data modules of a mask (table 10) and writes its format; a second call restores the data. */
    private void mask(int mask) {
        placeFormat(mask);
        for (int row = 0; row < size; row++) {
            for (int column = 0; column < size; column++) {
                isDark[row][column] ^= !isFixed[row][column] && isMasked(mask, row, column);
            }
        }
    }

    private static boolean isMasked(int mask, int row, int column) {
        int product = row * column;
        return 0
                == switch (mask) {
                    case 0 -> (row + column) % 2;
                    case 1 -> row % 2;
                    case 2 -> column % 3;
                    case 3 -> (row + column) % 3;
                    case 4 -> (row / 2 + column / 3) % 2;
                    case 5 -> product % 2 + product % 3;
                    case 6 -> (product % 2 + product % 3) % 2;
                    default -> ((row + column) % 2 + product % 3) % 2;
                };
    }

    /** The penalty of the four features of 7.8.3.1. */
    private int penalty() {
        int penalty = 0;
        int dark = 0;
        for (int i = 0; i < size; i++) {
            int line = i;
            penalty += linePenalty(column -> isDark[line][column]) + linePenalty(row -> isDark[row][line]);
            for (int j = 0; j < size; j++) {
                dark += isDark[i][j] ? 1 : 0;
                boolean isBlock = i > 0
                        && j > 0
                        && isDark[i][j] == isDark[i - 1][j]
                        && isDark[i][j] == isDark[i][j - 1]
                        && isDark[i][j] == isDark[i - 1][j - 1];
                penalty += isBlock ? PENALTY[1] : 0;
            }
        }
        return penalty + Math.abs(dark * 20 - size * size * 10) / (size * size) * PENALTY[3];
    }

    private int linePenalty(IntPredicate dark) {
        int penalty = 0;
        int run = 0;
        StringBuilder line = new StringBuilder();
        for (int i = 0; i < size; i++) {
            run = i > 0 && dark.test(i) == dark.test(i - 1) ? run + 1 : 1;
            penalty += run == 5 ? PENALTY[0] : run > 5 ? 1 : 0;
            line.append(dark.test(i) ? '1' : '0');
        }
        String reversed = new StringBuilder(FINDER_LIKE).reverse().toString();
        for (int i = 0; i + FINDER_LIKE.length() <= size; i++) {
            penalty += line.indexOf(FINDER_LIKE, i) == i || line.indexOf(reversed, i) == i ? PENALTY[2] : 0;
        }
        return penalty;
    }
}
