package simgsm.abis;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

class RtpPacketTest {
    private static final String A_LAW_PAYLOAD = "d5".repeat(160);

    @Test
    void aPacketIsTwelveOctetsAndTheFrame() {
        RtpPacket packet = new RtpPacket(RtpPacket.A_LAW, 0xfffe, 0xffff_ff60L, 0x89abcdefL, octets(A_LAW_PAYLOAD));

        assertEquals(
                "8008fffeffffff6089abcdef" + A_LAW_PAYLOAD,
                OctetString.of(packet.encode()).toString());
    }

    @Test
    void aPacketIsReadBack() throws ProtocolViolation {
        RtpPacket packet = RtpPacket.decode(octets("8083000100000002000000ff" + "d1".repeat(33)));

        assertEquals(RtpPacket.GSM_FULL_RATE, packet.payloadType());
        assertEquals(1, packet.sequence());
        assertEquals(2, packet.timestamp());
        assertEquals(255, packet.source());
        assertArrayEquals(octets("d1".repeat(33)), packet.payload());
    }

    @Test
    void contributingSourcesAndAnExtensionAreReadOver() throws ProtocolViolation {
        RtpPacket packet = RtpPacket.decode(
                octets("910800010000000200000003" + "00000004" + "abcd0001" + "00000005" + A_LAW_PAYLOAD));

        assertArrayEquals(octets(A_LAW_PAYLOAD), packet.payload());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "80",
                "800800010000000200000003",
                "800800010000000200000003d5",
                "806500010000000200000003d5",
                "4008000100000002000000030000",
                "9f0800010000000200000003",
                "910800010000000200000003000000"
            })
    void brokenPacketsAreRefused(String hex) {
        assertThrows(ProtocolViolation.class, () -> RtpPacket.decode(octets(hex)));
    }

    @Test
    void nonsenseIsRefusedAtBirth() {
        byte[] frame = new byte[160];
        assertThrows(IllegalArgumentException.class, () -> new RtpPacket(8, 0, 0, 0, new byte[159]));
        assertThrows(IllegalArgumentException.class, () -> new RtpPacket(0, 0, 0, 0, frame));
        assertThrows(IllegalArgumentException.class, () -> new RtpPacket(8, 65536, 0, 0, frame));
        assertThrows(IllegalArgumentException.class, () -> new RtpPacket(8, 0, -1, 0, frame));
        assertThrows(IllegalArgumentException.class, () -> new RtpPacket(8, 0, 0, 1L << 32, frame));
    }

    private static byte[] octets(String hex) {
        return OctetString.ofHex(hex).toArray();
    }
}
