package simgsm.sim;

import java.security.GeneralSecurityException;
import java.util.Arrays;
import javax.crypto.Cipher;
import javax.crypto.spec.SecretKeySpec;
import simgsm.octets.OctetString;
import simgsm.octets.Octets;

/**
 * MILENAGE, the authentication functions of most cards (TS 35.206): f1 to f5* over AES-128 with the key K and
 * the operator's value OPc, 16 octets each. The constants are the standard's: r1 to r5 are 64, 0, 32, 64 and 96 bits, c1
 * to c5 are 0, 1, 2, 4 and 8. One thread at a time.
 */
public final class Milenage {
    /** K, OP, OPc and RAND. */
    public static final int KEY_LENGTH = 16;
    /** SQN, the sequence number of a challenge. */
    public static final int SEQUENCE_LENGTH = 6;
    /** AMF, the authentication management field. */
    public static final int MANAGEMENT_LENGTH = 2;

    private static final int BLOCK_LENGTH = 16;
    private static final int MAC_LENGTH = 8;
    private static final int RESPONSE_LENGTH = 8;

    private final Cipher cipher;
    private final byte[] opc;

    /** @param k the subscriber's key; @param opc the operator's value for this key, see {@link #opc} */
    public Milenage(OctetString k, OctetString opc) {
        this.cipher = cipher(checked("K", k, KEY_LENGTH));
        this.opc = checked("OPc", opc, KEY_LENGTH);
    }

    /** Derives OPc from OP and K: OP xor E[OP] under K (TS 35.206, 4.1). */
    public static OctetString opc(OctetString k, OctetString op) {
        byte[] value = checked("OP", op, KEY_LENGTH);
        return OctetString.of(xor(encrypt(cipher(checked("K", k, KEY_LENGTH)), value), value));
    }

    /** MAC-A, 8 octets: authenticates the network. */
    public OctetString f1(OctetString rand, OctetString sqn, OctetString amf) {
        return part(firstOutput(rand, sqn, amf), 0, MAC_LENGTH);
    }

    /** MAC-S, 8 octets: authenticates the card in a resynchronisation. */
    public OctetString f1Star(OctetString rand, OctetString sqn, OctetString amf) {
        return part(firstOutput(rand, sqn, amf), MAC_LENGTH, 2 * MAC_LENGTH);
    }

    /** RES, 8 octets: the response of the card. */
    public OctetString f2(OctetString rand) {
        return part(output(rand, 0, 1), BLOCK_LENGTH - RESPONSE_LENGTH, BLOCK_LENGTH);
    }

    /** CK, 16 octets: for ciphering. */
    public OctetString f3(OctetString rand) {
        return part(output(rand, 4, 2), 0, BLOCK_LENGTH);
    }

    /** IK, 16 octets: for integrity. */
    public OctetString f4(OctetString rand) {
        return part(output(rand, 8, 4), 0, BLOCK_LENGTH);
    }

    /** AK, 6 octets: anonymity key, which conceals SQN in a challenge. */
    public OctetString f5(OctetString rand) {
        return part(output(rand, 0, 1), 0, SEQUENCE_LENGTH);
    }

    /** AK of a resynchronisation, 6 octets. */
    public OctetString f5Star(OctetString rand) {
        return part(output(rand, 12, 8), 0, SEQUENCE_LENGTH);
    }

    /** OUT1: SQN and AMF, twice, rotated by r1 and combined with the encrypted challenge. */
    private byte[] firstOutput(OctetString rand, OctetString sqn, OctetString amf) {
        byte[] once = Arrays.copyOf(checked("SQN", sqn, SEQUENCE_LENGTH), BLOCK_LENGTH / 2);
        System.arraycopy(checked("AMF", amf, MANAGEMENT_LENGTH), 0, once, SEQUENCE_LENGTH, MANAGEMENT_LENGTH);
        byte[] in1 = Arrays.copyOf(once, BLOCK_LENGTH);
        System.arraycopy(once, 0, in1, BLOCK_LENGTH / 2, BLOCK_LENGTH / 2);
        byte[] rotated = rotated(xor(in1, opc), BLOCK_LENGTH / 2);
        return xor(encrypt(cipher, xor(challenge(rand), rotated)), opc);
    }

    /** OUT2 to OUT5. @param rotation r of the function, octets; @param constant the last octet of its c */
    private byte[] output(OctetString rand, int rotation, int constant) {
        byte[] in = rotated(xor(challenge(rand), opc), rotation);
        in[BLOCK_LENGTH - 1] ^= (byte) constant;
        return xor(encrypt(cipher, in), opc);
    }

    /** TEMP: the encrypted challenge. */
    private byte[] challenge(OctetString rand) {
        return encrypt(cipher, xor(checked("RAND", rand, KEY_LENGTH), opc));
    }

    /** Rotated left, towards the first octet. */
    private static byte[] rotated(byte[] block, int octets) {
        byte[] result = new byte[BLOCK_LENGTH];
        for (int i = 0; i < BLOCK_LENGTH; i++) {
            result[i] = block[(i + octets) % BLOCK_LENGTH];
        }
        return result;
    }

    static byte[] xor(byte[] one, byte[] other) {
        byte[] result = new byte[one.length];
        for (int i = 0; i < result.length; i++) {
            result[i] = (byte) (one[i] ^ other[i]);
        }
        return result;
    }

    private static OctetString part(byte[] block, int from, int to) {
        return OctetString.of(Octets.range(block, from, to));
    }

    private static byte[] checked(String what, OctetString octets, int length) {
        return octets.requireLength(what, length).toArray();
    }

    /** ECB, because each call encrypts a single block (TS 35.206, 5). */
    private static Cipher cipher(byte[] key) {
        try {
            Cipher made = Cipher.getInstance("AES/ECB/NoPadding");
            made.init(Cipher.ENCRYPT_MODE, new SecretKeySpec(key, "AES"));
            return made;
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java platform has AES: " + e.getMessage(), e);
        }
    }

    private static byte[] encrypt(Cipher cipher, byte[] block) {
        try {
            return cipher.doFinal(block);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("AES refused a whole block: " + e.getMessage(), e);
        }
    }
}
