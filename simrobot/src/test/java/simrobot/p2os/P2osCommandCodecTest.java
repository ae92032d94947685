package simrobot.p2os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class P2osCommandCodecTest {
    private static P2osCommand decoded(byte[] packet) {
        return P2osCommandCodec.decode(Arrays.copyOfRange(packet, 3, packet.length - 2));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, -1, 500, -300, 32767, -32767, 65535})
    void aNumberIsReadAsItWasWritten(int millimeters) {
        assertEquals(
                new P2osCommand.Move(millimeters),
                decoded(P2osCommandCodec.packet(P2osCommandNumber.MOVE, millimeters)));
    }

    @ParameterizedTest
    @CsvSource({"10, 10", "-10, 5", "5, -10", "-1, -1", "127, -128"})
    void twoWheelsShareANumberInEitherByteOrder(int left, int right) {
        int word = (left & 0xFF) << 8 | right & 0xFF;
        P2osCommand expected = new P2osCommand.WheelVelocities(left, right);
        assertEquals(expected, decoded(P2osCommandCodec.packet(P2osCommandNumber.VEL2, word)));
        assertEquals(expected, decoded(P2osCommandCodec.packet(P2osCommandNumber.VEL2, (short) word)));
    }

    @Test
    void openTakesAnArgumentOrNone() {
        assertEquals(new P2osCommand.Open(), decoded(P2osCommandCodec.packet(P2osCommandNumber.OPEN)));
        assertEquals(new P2osCommand.Open(), decoded(P2osCommandCodec.packet(P2osCommandNumber.OPEN, 1)));
    }

    @Test
    void bothNumbersOfRotationAreOne() {
        assertEquals(new P2osCommand.Rotate(-20), decoded(P2osCommandCodec.packet(P2osCommandNumber.RVEL, -20)));
        assertEquals(new P2osCommand.Rotate(20), decoded(P2osCommandCodec.packet(P2osCommandNumber.ROTATE, 20)));
    }

    @Test
    void pollingCountsSonarsFromOneOnTheWire() {
        byte[] order = {1, 0, 16, 17, (byte) 200, 5};
        assertEquals(
                new P2osCommand.Polling(List.of(0, 15, 4)),
                decoded(P2osCommandCodec.packet(P2osCommandNumber.POLLING, order)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"0b", "0b3b", "0b3bc8", "0b2bc800", "0bffc800", "03", "032b05010203", "e0", "e02b00", "28"})
    void anArgumentThatIsMissingOrOfAnotherKindIsNotHeeded(String hex) {
        byte[] data = java.util.HexFormat.of().parseHex(hex);
        assertEquals(new P2osCommand.Unheeded(data[0] & 0xFF), P2osCommandCodec.decode(data));
    }

    @Test
    void simulatorPosesAreThreeLongNumbers() {
        byte[] data = P2osPacket.data()
                .octet(P2osCommandNumber.SIM_SET_POSE)
                .octet(0x3B)
                .fourOctets(-1500)
                .fourOctets(70000)
                .fourOctets(90)
                .toArray();
        assertEquals(new P2osCommand.SimPose(-1500, 70000, 90), P2osCommandCodec.decode(data));
    }

    @Test
    void bumpStallHasABitForEachSide() {
        assertEquals(
                new P2osCommand.BumpStall(false, true),
                decoded(P2osCommandCodec.packet(P2osCommandNumber.BUMPSTALL, 2)));
    }

    @Test
    void anyBytesDecodeToSomething() {
        Random random = new Random(5);
        for (int i = 0; i < 100_000; i++) {
            byte[] data = new byte[1 + random.nextInt(20)];
            random.nextBytes(data);
            assertNotNull(P2osCommandCodec.decode(data));
        }
    }

    @Test
    void simulatorExitAndOldBatteryInfoAreNotHeeded() {
        assertInstanceOf(P2osCommand.Unheeded.class, decoded(P2osCommandCodec.packet(62, 1)));
        assertInstanceOf(P2osCommand.Unheeded.class, decoded(P2osCommandCodec.packet(239)));
    }

    @Test
    void whatDoesNotFitIsNotWritten() {
        assertThrows(IllegalArgumentException.class, () -> P2osCommandCodec.packet(8, 70000));
        assertThrows(IllegalArgumentException.class, () -> P2osCommandCodec.packet(15, new byte[196]));
    }
}
