package simgsm.center.journal;

/**
 * f2 to f4 of MILENAGE (TS 35.206) over an AES-128 that is computed bit by bit from FIPS 197: no platform cipher, no
 * tables, no arrays of octets in loops that a compiler vectorises. Slow; for comparison with the product's.
 */
final class PlainMilenage {
    private static final int ROUNDS = 10;
    private static final int BLOCK = 16;

    private PlainMilenage() {}

    /** OUT2 to OUT4. @param rotation octets to the left; @param constant last octet of c */
    static int[] output(int[] k, int[] opc, int[] rand, int rotation, int constant) {
        int[] temp = encrypt(k, xor(rand, opc));
        int[] mixed = xor(temp, opc);
        int[] in = new int[BLOCK];
        for (int i = 0; i < BLOCK; i++) {
            in[i] = mixed[(i + rotation) & 15];
        }
        in[15] ^= constant;
        return xor(encrypt(k, in), opc);
    }

    /** SRES, 4 octets: both halves of RES (TS 33.102, 6.8.1.2, conversion function c2). */
    static int[] sres(int[] k, int[] opc, int[] rand) {
        int[] out = output(k, opc, rand, 0, 1);
        return new int[] {out[8] ^ out[12], out[9] ^ out[13], out[10] ^ out[14], out[11] ^ out[15]};
    }

    private static int[] xor(int[] one, int[] other) {
        int[] result = new int[BLOCK];
        for (int i = 0; i < BLOCK; i++) {
            result[i] = one[i] ^ other[i];
        }
        return result;
    }

    static int[] encrypt(int[] key, int[] block) {
        int[] roundKey = key.clone();
        int[] state = xor(block, roundKey);
        int constant = 1;
        for (int round = 1; round <= ROUNDS; round++) {
            int[] shifted = new int[BLOCK];
            for (int i = 0; i < BLOCK; i++) {
                shifted[i] = substitute(state[(i + 4 * (i & 3)) & 15]);
            }
            for (int i = 0; i < 4; i++) {
                roundKey[i] ^= substitute(roundKey[12 + (i + 1 & 3)]) ^ (i == 0 ? constant : 0);
            }
            for (int i = 4; i < BLOCK; i++) {
                roundKey[i] ^= roundKey[i - 4];
            }
            constant = times(constant, 2);
            state = xor(round == ROUNDS ? shifted : mixed(shifted), roundKey);
        }
        return state;
    }

    private static int[] mixed(int[] in) {
        int[] out = new int[BLOCK];
        for (int i = 0; i < BLOCK; i++) {
            int column = i & 12;
            out[i] = times(in[i], 2)
                    ^ times(in[column | (i + 1 & 3)], 3)
                    ^ in[column | (i + 2 & 3)]
                    ^ in[column | (i + 3 & 3)];
        }
        return out;
    }

    /** Product in GF(2^8) modulo x^8 + x^4 + x^3 + x + 1. */
    private static int times(int one, int other) {
        int product = 0;
        for (int bit = 7; bit >= 0; bit--) {
            product = product << 1 ^ (product >> 7) * 0x11b ^ (other >> bit & 1) * one;
        }
        return product;
    }

    /** The S-box: the inverse, which is the 254th power, and the affine map. */
    private static int substitute(int value) {
        int inverse = 1;
        for (int bit = 7; bit >= 0; bit--) {
            inverse = times(inverse, inverse);
            inverse = (254 >> bit & 1) == 1 ? times(inverse, value) : inverse;
        }
        int doubled = inverse << 8 | inverse;
        return (inverse ^ doubled >> 4 ^ doubled >> 5 ^ doubled >> 6 ^ doubled >> 7) & 0xff ^ 0x63;
    }
}
