package simrobot.p2os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Octets as other P2OS programs sent them. */
class P2osPacketTest {
    private static final HexFormat HEX = HexFormat.of();

    private final List<String> packets = new ArrayList<>();
    private final P2osPacketReader reader = new P2osPacketReader(data -> packets.add(HEX.formatHex(data)));

    private void read(String hex) {
        reader.read(bytes(hex), 0);
    }

    private static byte[] bytes(String hex) {
        return HEX.parseHex(hex.replace(" ", ""));
    }

    @ParameterizedTest
    @CsvSource({"0, fa fb 03 00 00 00", "1, fa fb 03 01 00 01", "2, fa fb 03 02 00 02", "29, fa fb 03 1d 00 1d"})
    void commandsWithoutArgumentAreWrittenAsTheyAreSeenOnTheWire(int number, String octets) {
        assertEquals(octets.replace(" ", ""), HEX.formatHex(P2osCommand.packet(number)));
    }

    @ParameterizedTest
    @CsvSource({
        "1, 1, fa fb 06 01 3b 01 00 02 3b",
        "4, 1, fa fb 06 04 3b 01 00 05 3b",
        "8, 500, fa fb 06 08 3b f4 01 fc 3c",
        "8, -300, fa fb 06 08 1b 2c 01 34 1c",
        "13, 90, fa fb 06 0d 3b 5a 00 67 3b",
        "13, -90, fa fb 06 0d 1b 5a 00 67 1b",
        "11, 200, fa fb 06 0b 3b c8 00 d3 3b"
    })
    void commandsWithANumberAreWrittenAndReadAsTheyAreSeenOnTheWire(int number, int argument, String octets) {
        assertEquals(octets.replace(" ", ""), HEX.formatHex(P2osCommand.packet(number, argument)));
        read(octets);
        assertEquals(1, packets.size());
        assertEquals(0, reader.rejected());
    }

    @Test
    void theIntroductionIsFramedAsSeenOnTheWire() {
        byte[] data = P2osPacket.data()
                .octet(2)
                .zeroEnded("SimRobot")
                .zeroEnded("Pioneer")
                .zeroEnded("p2dx")
                .toArray();
        String framed = HEX.formatHex(P2osPacket.of(data));
        assertEquals("fafb1902" + HEX.formatHex("SimRobot".getBytes()) + "00", framed.substring(0, 26));
        assertEquals("00" + "0084", framed.substring(framed.length() - 6));
    }

    @Test
    void packetsAreFoundInAnyPieces() {
        byte[] stream = bytes("fa fb 06 08 3b f4 01 fc 3c fa fb 03 1d 00 1d");
        for (byte octet : stream) {
            reader.read(new byte[] {octet}, 0);
        }
        assertEquals(List.of("083bf401", "1d"), packets);
    }

    @Test
    void rubbishBeforeBetweenAndAfterIsPassedOver() {
        read("00 fa 12 fb fa fa fb 03 01 00 01 ff ff fa fb 03 02 00 02 fa");
        assertEquals(List.of("01", "02"), packets);
    }

    @Test
    void aWrongChecksumDropsThePacketAndNothingElse() {
        read("fa fb 06 08 3b f4 01 fc 3d");
        assertEquals(List.of(), packets);
        assertEquals(1, reader.rejected());
        read("fa fb 03 1d 00 1d");
        assertEquals(List.of("1d"), packets);
    }

    @ParameterizedTest
    @ValueSource(strings = {"00", "01", "02", "c9", "fa", "ff"})
    void aCountThatCannotBeIsPassedOver(String count) {
        read("fa fb " + count + " fa fb 03 00 00 00");
        assertEquals(List.of("00"), packets);
        assertEquals(1, reader.rejected());
    }

    @Test
    void theLongestPacketIs200AfterTheCount() {
        byte[] longest = new byte[198];
        new Random(1).nextBytes(longest);
        reader.read(P2osPacket.of(longest), 0);
        assertEquals(List.of(HEX.formatHex(longest)), packets);
        assertThrows(IllegalArgumentException.class, () -> P2osPacket.of(new byte[199]));
        assertThrows(IllegalArgumentException.class, () -> P2osPacket.of(new byte[0]));
    }

    @Test
    void aPacketThatNeverEndsIsGivenUpForAFreshOne() {
        reader.read(bytes("fa fb 20 08 3b"), 0);
        reader.read(bytes("fa fb 03 00 00 00"), 150_000_000);
        assertEquals(List.of("00"), packets);
    }

    @Test
    void aPacketThatComesSlowlyIsStillRead() {
        reader.read(bytes("fa fb 06 08 3b"), 0);
        reader.read(bytes("f4 01 fc 3c"), 900_000_000);
        assertEquals(List.of("083bf401"), packets);
    }

    @Test
    void theChecksumRollsOverAndTakesAnOddByteIntoTheLowHalf() {
        assertEquals(0x0001, P2osPacket.checksum(bytes("ffff0002"), 0, 4));
        assertEquals(0x1234 ^ 0x56, P2osPacket.checksum(bytes("123456"), 0, 3));
    }
}
