package simgsm.cells.cipher;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.HexFormat;
import org.junit.jupiter.api.Test;
import simgsm.air.CipherAlgorithm;
import simgsm.octets.OctetString;

class CipherTest {
    private static String hex(byte[] bits, int from) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 112; i += 8) {
            int octet = 0;
            for (int b = 0; b < 8; b++) {
                octet = octet << 1 | bits[from + i + b];
            }
            text.append(String.format("%02x", octet));
        }
        return text.toString();
    }

    /** The vector of Briceno, Goldberg and Wagner (1999), whose key has its last octet first. */
    @Test
    void a5_1GivesThePublishedStreams() {
        byte[] kc = HexFormat.of().parseHex("efcdab8967452312");
        byte[] bits = A51.stream(kc, 0x134, 228);
        assertEquals("534eaa582fe8151ab6e1855a728c", hex(bits, 0));
        assertEquals("24fd35a35d5fb6526d32f906df1a", hex(bits, 114));
    }

    /** TS 35.203, 3.3, test set 1. */
    @Test
    void kasumiGivesThePublishedBlock() {
        Kasumi kasumi = new Kasumi(HexFormat.of().parseHex("2bd6459f82c5b300952c49104881ff48"));
        assertEquals("df1f9b251c0bf45f", String.format("%016x", kasumi.encrypt(0xea024714ad5c4d84L)));
    }

    /** TS 55.217, A5/3 test set 1. */
    @Test
    void a5_3GivesThePublishedStreams() {
        byte[] bits = A53.stream(HexFormat.of().parseHex("2bd6459f82c5bc00"), 0x24f20f, 228);
        assertEquals("889eeaaf9ed1ba1abbd8436232e4", hex(bits, 0));
        assertEquals("5ca3406aa244cf69cf047aada2df", hex(bits, 114));
    }

    @Test
    void withoutCipheringTheStreamIsZero() {
        assertArrayEquals(new byte[114], CipherKey.NONE.stream(77, true));
    }

    @Test
    void theDirectionsHaveDifferentStreams() {
        CipherKey key = new CipherKey(CipherAlgorithm.A5_1, OctetString.ofHex("efcdab8967452312"));
        // T1 0, T3 9, T2 20: the count 0x134
        long frame = 0;
        while (frame % 51 != 9 || frame % 26 != 20) {
            frame++;
        }
        assertEquals("534eaa582fe8151ab6e1855a728c", hex(key.stream(frame, false), 0));
        assertEquals("24fd35a35d5fb6526d32f906df1a", hex(key.stream(frame, true), 0));
    }
}
