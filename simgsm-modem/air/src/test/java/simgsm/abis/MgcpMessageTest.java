package simgsm.abis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.abis.MgcpMessage.Head;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.air.ProtocolViolation;

class MgcpMessageTest {
    private static final MgcpMessage CREATE = MgcpMessage.create(7, "3", new MediaAddress("127.0.0.1", 16384));

    static List<MgcpMessage> messages() {
        return List.of(
                CREATE,
                CREATE.created("9", new MediaAddress("::1", 16386)),
                CREATE.answered(Head.NO_RESOURCES),
                MgcpMessage.delete(8, "3", "9"),
                MgcpMessage.delete(8, "3", "9").answered(Head.DELETED));
    }

    @ParameterizedTest
    @MethodSource("messages")
    void everyMessageIsReadBack(MgcpMessage message) throws ProtocolViolation {
        assertEquals(message, MgcpMessage.decode(message.encode()));
    }

    @Test
    void aConnectionIsCreatedWithTheCentresAddress() {
        String text = new String(CREATE.encode(), StandardCharsets.US_ASCII);

        assertTrue(text.startsWith("CRCX 7 rtpbridge/3@mgw MGCP 1.0\r\nC: 3\r\n"), text);
        assertTrue(text.contains("\r\n\r\nv=0\r\n"), text);
        assertTrue(text.contains("c=IN IP4 127.0.0.1\r\n"), text);
        assertTrue(text.endsWith("a=ptime:20\r\n"), text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "\n", "\r\n\r\n", "hello", "CRCX", "CRCX x y", "MDCX 1 a MGCP 1.0", "999 1 OK"})
    void anythingElseIsAViolation(String text) {
        assertThrows(ProtocolViolation.class, () -> MgcpMessage.decode(text.getBytes(StandardCharsets.US_ASCII)));
    }

    @Test
    void aPortThatIsNoneGivesNoAddress() throws ProtocolViolation {
        String text = "200 1 OK\r\n\r\nc=IN IP4 127.0.0.1\r\nm=audio 70000 RTP/AVP 8\r\n";

        assertEquals(
                Optional.empty(),
                MgcpMessage.decode(text.getBytes(StandardCharsets.US_ASCII)).media());
    }

    @Test
    void spoiltTextsGiveAMessageOrAViolationAndNothingElse() {
        Random random = new Random(3435);
        for (int round = 0; round < 20_000; round++) {
            byte[] octets = CREATE.encode();
            for (int i = 0; i < 4; i++) {
                octets[random.nextInt(octets.length)] = (byte) random.nextInt(256);
            }
            try {
                MgcpMessage.decode(octets);
            } catch (ProtocolViolation expected) {
                assertTrue(expected.getMessage().length() > 0);
            }
        }
    }
}
