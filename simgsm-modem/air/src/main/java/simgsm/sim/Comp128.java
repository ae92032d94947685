package simgsm.sim;

import simgsm.octets.OctetString;
import simgsm.octets.Octets;

/**
 * COMP128: A3 and A8 of older cards in one function, in three versions. Its owners have published none; the tables are
 * those of all known implementations. Version 1 reveals a card's key after some 150 000 chosen challenges, and the last
 * 10 bits of its Kc are 0. Version 2 is another function with the same 10 bits; version 3 has all bits of Kc.
 */
final class Comp128 {
    private static final int KEY = 16;
    private static final int STATE = 32;
    private static final int LEVELS = 5;

    /** The table of each level of version 1. The second half of the first is its first half with neighbours swapped. */
    private static final byte[][] LEVEL_TABLES = {
        withSwapped(octets("66b1baa2029c704b3719080cfbc1f6bc6dd597352a4fbf73e9f2a4dfd1946ca1fc25f42f40d306edb9a08b71"
                + "4c8a3b46431a0d9d3fb3dd1ed624a645987ccf74f7c229544701310e5f23a915604ed7e1b6f31c5cc976044a"
                + "f880110b9284f530955a782757e66ae8af137ebeca8d89b0fa1b6528dbe33a1433b262d88c1620793d67cb48"
                + "1d6e55d4b4cc96b70f42acc438c59e00642d990790dea3a73c87d2e7aea526f9e022dce5d9d0f144cebd7dff"
                + "ef36a8597b7a499175ea8f6381c8c05268aa88eb5d51cdadec5e69342ee4c60539fe619b8e85c7abbb3241b5"
                + "7f6b93e2b8da83214d561f2c583eee12182b9a17509f866f0972035b1082530ac3f0fd77")),
        octets("130b50722b01455e27127f756103552b1b7c46532f473f0a2f594f040e3b0b05236b67441556245b557e2032"
                + "6d5e7806354f1c2d635f292258445d376e7d69145a504c60173c594079380e4a6508134e4c42682e6f322003"
                + "27003a195c16123339417774166d07563b5d3e6e4e634d430c71576266055821263817084b2d0d4b5f3f1c31"
                + "7b7814702c1e0f626a02671d526b2a7c181e29106c64752849280772527324700c6664545c3048610936374a"
                + "717b111a353a0409457a15762a3c1b49767d220f417354403e514601186f79536851317f30691f0a065b5725"
                + "1036747e1f260d00486a4d3d1a432e1d60253d3465112c6c473442392133195a02777a23"),
        octets("34322c061531293b27331920332f342b250428223d0c1c043a17080f0c160912370a212332012b03390d3e0e"
                + "072a2c3b3e391b06081f1a3629162d14270310383002151c242a3c212212000b180a113d1d0e2d1a372e0b11"
                + "362e09181e3c20001426021e3a230110382817300d13131b1f352f263f0f3105253519243f1d0507"),
        octets("01051d0619011217111300091819061f1c14181e041b030d0f100e120403080914000c1a15081c021d020f07"
                + "0b160e0a11150c1e1a1b101f0b070d170a051613"),
        octets("0f0c0a04010e0b0705000e0701020d080a03040906000302050608090b0d0f0c")
    };

    /** The substitutions of versions 2 and 3. */
    private static final byte[] INNER =
            octets("aa2a5f8d6d1e47591a93e7cdefd47c81d84f0fb9990efba200f1acc52b0ac2eb0614482d8f68a177298826bd"
                    + "87195d12e0abfcc33f133aa5173785fed690dcb29c346ee161b78c273558dba710c63ede4c8baf5e33867316"
                    + "4301f9d90305e88a1f3874a34680ea84e5b8f40d2249e99ab383d7ec8edf1b39f66cd308fd5542f5c14ebe04"
                    + "1107967f98d525ba02f32ea944653caed09eb045eebf5a53a67d4d3b155c3197a8630932927175e441e62852"
                    + "36ede3661c246b182c7ecec93d72a4cfb51d5b40ddff309bc06fb4d2b6f7cb94d162ad0b4b7bfa76202ff0ca"
                    + "4ab16450c421f8569d89788254cc7a51f2bcc895e2daa0bb6a2357696091c79f0c796770");

    private static final byte[] OUTER =
            octets("c5eb3c9762600364f8762a75acd3b5cb3d7e9c5795e03784ba3feeff55539821a0b8d2db9f0bb4c282d49305"
                    + "d75c1b2e71bb3419b94fdd30461f650fc3c932de89e9e56a7ab7b2b190cfeab625fee3e736d18541ca45eddc"
                    + "bd927844157d261e029b35c4aeb033f6a74c6e145279677038ad31d9fc0072e47b0c5da1fde8f0af4380169e"
                    + "59124d6dbe113e0499a33b918a074acd0aa2502d686f96d69a1cbfa9d558c1c6c8f527a47c544e01bcaa1756"
                    + "e28d2006837fc728871039475be1a8f2ce61a62c0e5aecefe6f4df6c667794fb1dd80809f9d018695e22405f"
                    + "734886cc2bf7f3da2f3a496bf1b37442248f51fa8b130d8e8c81c063ab9d88294b23a51a");

    private Comp128() {}

    private static byte[] octets(String hex) {
        return OctetString.ofHex(hex).toArray();
    }

    private static byte[] withSwapped(byte[] half) {
        byte[] whole = new byte[2 * half.length];
        for (int i = 0; i < half.length; i++) {
            whole[i] = half[i];
            whole[half.length + i] = half[i ^ 1];
        }
        return whole;
    }

    /** @param k 16 octets; @param rand 16 octets */
    static GsmVector first(byte[] k, byte[] rand) {
        byte[] state = joined(k, rand);
        for (int round = 1; round < 8; round++) {
            compress(state);
            state = joined(k, permuted(state));
        }
        compress(state);
        byte[] nibbles = new byte[24];
        System.arraycopy(state, 0, nibbles, 0, 8);
        System.arraycopy(state, 18, nibbles, 8, 14);
        byte[] packed = new byte[12];
        for (int i = 0; i < packed.length; i++) {
            packed[i] = (byte) (nibbles[2 * i] << 4 | nibbles[2 * i + 1]);
        }
        // Kc: the last 54 bits of the 128, then 10 bits of 0
        byte[] kc = new byte[GsmVector.KC_LENGTH];
        for (int i = 0; i < kc.length - 1; i++) {
            kc[i] = (byte) (packed[4 + i] << 2 | (packed[5 + i] & 0xff) >> 6);
        }
        return new GsmVector(OctetString.of(Octets.range(packed, 0, GsmVector.SRES_LENGTH)), OctetString.of(kc));
    }

    /** Five levels of a butterfly over the 32 octets; level n leaves 8 - n bits in each. */
    private static void compress(byte[] state) {
        for (int level = 0; level < LEVELS; level++) {
            byte[] table = LEVEL_TABLES[level];
            int distance = KEY >> level;
            for (int i = 0; i < STATE; i++) {
                if ((i & distance) == 0) {
                    int low = state[i] & 0xff;
                    int high = state[i + distance] & 0xff;
                    state[i] = table[low + 2 * high & table.length - 1];
                    state[i + distance] = table[2 * low + high & table.length - 1];
                }
            }
        }
    }

    /** The 128 bits of the 32 nibbles; bit i of the result is bit 17 i of them. */
    private static byte[] permuted(byte[] nibbles) {
        byte[] result = new byte[KEY];
        for (int i = 0; i < 8 * KEY; i++) {
            int from = i * 17 % (8 * KEY);
            int bit = nibbles[from / 4] >> 3 - from % 4 & 1;
            result[i / 8] |= (byte) (bit << 7 - i % 8);
        }
        return result;
    }

    /** @param hidesBits true for version 2 */
    static GsmVector later(byte[] k, byte[] rand, boolean hidesBits) {
        byte[] block = reversed(rand);
        byte[] mixed = Milenage.xor(reversed(k), block);
        for (int round = 0; round < 8; round++) {
            block = scattered(spread(joined(block, mixed)));
        }
        byte[] output = reversed(block);
        byte[] kc = Octets.range(output, 8, KEY);
        if (hidesBits) {
            kc[6] &= (byte) 0xfc;
            kc[7] = 0;
        }
        return new GsmVector(OctetString.of(Octets.range(output, 0, GsmVector.SRES_LENGTH)), OctetString.of(kc));
    }

    /** At each level the halves are combined twice; the results alternate in runs of 1, 2, 4, 8 and 16 octets. */
    private static byte[] spread(byte[] state) {
        byte[] from = state;
        for (int level = 0; level < LEVELS; level++) {
            byte[] to = new byte[STATE];
            for (int i = 0; i < KEY; i++) {
                byte once = substituted(from[KEY + i], from[i]);
                int place = (i >> level << level + 1) + i % (1 << level);
                to[place] = once;
                to[place + (1 << level)] = substituted(once, from[KEY + i]);
            }
            from = to;
        }
        return from;
    }

    private static byte substituted(byte inner, byte outer) {
        return OUTER[(INNER[inner & 0xff] ^ outer) & 0xff];
    }

    /** Bit n of the result, counted from the low end of each octet, is bit 19 (n + 1) of the 256. */
    private static byte[] scattered(byte[] state) {
        byte[] result = new byte[KEY];
        for (int n = 0; n < 8 * KEY; n++) {
            int from = 19 * (n + 1) % (8 * STATE);
            result[n / 8] |= (byte) ((state[from / 8] >> from % 8 & 1) << n % 8);
        }
        return result;
    }

    private static byte[] joined(byte[] one, byte[] other) {
        byte[] result = new byte[STATE];
        System.arraycopy(one, 0, result, 0, KEY);
        System.arraycopy(other, 0, result, KEY, KEY);
        return result;
    }

    private static byte[] reversed(byte[] octets) {
        byte[] result = new byte[octets.length];
        for (int i = 0; i < octets.length; i++) {
            result[i] = octets[octets.length - 1 - i];
        }
        return result;
    }
}
