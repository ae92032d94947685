package simrobot.p2os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.process.BehaviourKind;
import vericommand.Pose;

class P2osCommandTest {
    private static P2osCommand decoded(byte[] packet) {
        return new P2osCommand(Arrays.copyOfRange(packet, 3, packet.length - 2));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, -1, 500, -300, 32767, -32767, 65535})
    void aNumberIsReadAsItWasWritten(int millimeters) {
        P2osCommand command = decoded(P2osCommand.packet(P2osCommandNumber.MOVE, millimeters));
        assertEquals(P2osCommandNumber.MOVE, command.number());
        assertTrue(command.hasInteger());
        assertEquals(millimeters, command.integer());
    }

    private static Pose after(int command, int argument) {
        return SessionBench.openedOnBareFloor()
                .say(command, argument)
                .seconds(1)
                .robot
                .pose();
    }

    @ParameterizedTest
    @CsvSource({"10, 10", "-10, 5", "5, -10", "-1, -1", "127, -128"})
    void twoWheelsShareANumberInEitherByteOrder(int left, int right) {
        int word = (left & 0xFF) << 8 | right & 0xFF;
        Pose moved = after(P2osCommandNumber.VEL2, word);
        double turn = Math.sin(Math.toRadians(moved.headingDegrees()));
        assertEquals(Math.signum(right - left), Math.signum(turn), "the faster wheel is outside");
        assertEquals(Math.signum(left + right), Math.signum(moved.xMeters()));
        assertEquals(moved, after(P2osCommandNumber.VEL2, (short) word));
    }

    @Test
    void bothNumbersOfRotationAreOne() {
        assertNotEquals(new Pose(0, 0, 0), after(P2osCommandNumber.ROTATE, -20));
        assertEquals(after(P2osCommandNumber.RVEL, -20), after(P2osCommandNumber.ROTATE, -20));
    }

    @Test
    void pollingCountsSonarsFromOneOnTheWire() {
        byte[] order = {1, 0, 16, 17, (byte) 200, 5};
        assertEquals(
                Optional.of(List.of(0, 15, 4)),
                decoded(P2osCommand.packet(P2osCommandNumber.POLLING, order)).sonars());
    }

    @ParameterizedTest
    @ValueSource(strings = {"0b", "0b3b", "0b3bc8", "0b2bc800", "0bffc800", "28"})
    void anIntegerThatIsMissingOrOfAnotherKindIsNotHeeded(String hex) {
        assertFalse(new P2osCommand(HexFormat.of().parseHex(hex)).hasInteger());
    }

    @ParameterizedTest
    @ValueSource(strings = {"03", "032b05010203", "033b0100"})
    void sonarsThatAreMissingOrCutOffAreNotHeeded(String hex) {
        assertEquals(Optional.empty(), new P2osCommand(HexFormat.of().parseHex(hex)).sonars());
    }

    @ParameterizedTest
    @ValueSource(strings = {"e0", "e02b00", "e03b00000000000000000000"})
    void aPoseThatIsMissingOrCutOffIsNotHeeded(String hex) {
        assertEquals(Optional.empty(), new P2osCommand(HexFormat.of().parseHex(hex)).pose());
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
        assertEquals(Optional.of(new Pose(-1.5, 70, 90)), new P2osCommand(data).pose());
    }

    @ParameterizedTest
    @ValueSource(ints = {62, 239, 200})
    void aCommandThatIsNotSupportedLeavesTheProcessRunning(int number) {
        SessionBench bench = SessionBench.opened();
        bench.robot.autonomy().begin(BehaviourKind.WANDER);
        bench.say(number).say(number, 1).seconds(0.1);
        assertTrue(bench.robot.autonomy().isActive());
        bench.say(P2osCommandNumber.VEL, 100);
        assertFalse(bench.robot.autonomy().isActive());
    }

    @Test
    void whatDoesNotFitIsNotWritten() {
        assertThrows(IllegalArgumentException.class, () -> P2osCommand.packet(8, 70000));
        assertThrows(IllegalArgumentException.class, () -> P2osCommand.packet(15, new byte[196]));
    }
}
