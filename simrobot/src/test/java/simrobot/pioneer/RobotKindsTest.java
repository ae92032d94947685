package simrobot.pioneer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.p2os.P2osCommandNumber;
import simrobot.pioneer.FakePioneer.Manner;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.RobotStatus;

/** Robots of all types, each counting in its own units, go as far as ordered; a type that is not known does not move. */
class RobotKindsTest {
    private static final double MOST_MILLIMETERS_OFF = 5;
    private static final double MOST_DEGREES_OFF = 0.5;

    static Collection<String> kinds() {
        return RobotKind.names();
    }

    private static FakePioneer fake(String kind, Manner manner) {
        return new FakePioneer(kind, RobotKind.named(kind).orElseThrow(), manner, Optional.empty());
    }

    private static void drives(FakePioneer fake, int centimeters) {
        double x = fake.x;
        double y = fake.y;
        double heading = fake.heading;
        MotionOutcome outcome = fake.order(new Instruction.Forward(centimeters));
        assertEquals(new MotionOutcome(MotionOutcome.Ending.DONE, centimeters), outcome);
        fake.seconds(1);
        assertEquals(
                centimeters * 10,
                (fake.x - x) * Math.cos(heading) + (fake.y - y) * Math.sin(heading),
                MOST_MILLIMETERS_OFF);
        assertEquals(Math.toDegrees(heading), Math.toDegrees(fake.heading), MOST_DEGREES_OFF);
    }

    private static void turns(FakePioneer fake, int degrees) {
        double heading = fake.heading;
        assertEquals(new MotionOutcome(MotionOutcome.Ending.DONE, degrees), fake.order(new Instruction.Turn(degrees)));
        fake.seconds(1);
        assertEquals(-degrees, Math.toDegrees(fake.heading - heading), MOST_DEGREES_OFF);
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void aRobotOfEachKindGoesAsFarAsOrdered(String kind) {
        FakePioneer fake = fake(kind, Manner.PROMPT);
        drives(fake, 100);
        turns(fake, 90);
        drives(fake, 20);
        turns(fake, 360);
        drives(fake, 1);
    }

    /** ARIA's own figures: what a metre is in the units of the later robots, and of some that were taken for others. */
    @ParameterizedTest
    @CsvSource({
        "p3dx, 0.485",
        "P3DX, 0.485",
        "p3dx-sh, 1",
        "p3at-sh, 1",
        "p3at, 0.465",
        "p2at8, 1.32",
        "p2ce, 0.826",
        "amigo, 0.5083",
        "amigo-sh, 1",
        "pion1m, 0.05066",
        "p2it, 1.136",
        "p2pb, 0.424",
        "powerbot-sh, 1"
    })
    void theUnitsOfAKindAreThoseOfAria(String kind, double millimetersPerUnit) {
        assertEquals(millimetersPerUnit, RobotKind.named(kind).orElseThrow().millimetersPerUnit());
    }

    static Stream<Manner> manners() {
        return Stream.of(
                new Manner(0.2, 0, 10, 100, 0),
                new Manner(0.5, 0, 30, 100, 0),
                new Manner(0, 15, 10, 100, 0),
                new Manner(0, 0, 60, 100, 0),
                new Manner(0, 0, 10, 50, 0),
                new Manner(0, 0, 10, 100, 3),
                new Manner(0.1, 10, 40, 100, 4));
    }

    @ParameterizedTest
    @MethodSource("manners")
    void aLaggingAJerkyAndADistantRobotGoAsFarAsOrdered(Manner manner) {
        FakePioneer fake = fake("p3dx", manner);
        for (int amount : List.of(1, 2, 7, 20, 50, 99, 180, 250, 333)) {
            drives(fake, amount);
            turns(fake, amount);
        }
        assertFalse(fake.commands.contains(P2osCommandNumber.MOVE), "no position command of the robot's is used");
        assertFalse(fake.commands.contains(P2osCommandNumber.DHEAD), "no position command of the robot's is used");
    }

    @Test
    void aRobotOfAnUnknownTypeIsNotMovedAndNamesItsType() {
        FakePioneer fake = new FakePioneer(
                "rover\u0007 9", RobotKind.named("p3dx").orElseThrow(), Manner.PROMPT, Optional.empty());
        fake.robot.setMotors(true);
        fake.motors = true;
        fake.seconds(3);
        assertEquals(RobotStatus.NO_MOTORS, fake.robot.status());
        assertEquals(Optional.of("rover??9"), fake.robot.unknownType());
        assertThrows(
                IllegalStateException.class, () -> fake.robot.start(new Instruction.Forward(20), fake.outcomes::add));
        assertFalse(fake.commands.contains(P2osCommandNumber.VEL));
        assertEquals(0, fake.robot.pose().xMeters(), "what it counts is not known either");
    }

    @Test
    void aRobotThatFallsSilentWhileDrivenGetsStopAndGoesOnWithTheNextPacket() {
        FakePioneer fake = fake("p3dx", Manner.PROMPT);
        double start = fake.x;
        fake.robot.start(new Instruction.Forward(200), fake.outcomes::add);
        fake.seconds(2);
        fake.commands.clear();
        fake.silent = true;
        fake.seconds(0.8);
        assertTrue(fake.commands.contains(P2osCommandNumber.STOP), fake.commands.toString());
        fake.silent = false;
        fake.seconds(8);
        assertEquals(MotionOutcome.Ending.DONE, fake.outcomes.get(0).ending());
        assertEquals(2000, fake.x - start, MOST_MILLIMETERS_OFF);
    }

    // ---- parameter files -----------------------------------------------------------------------------------------

    @TempDir
    Path folder;

    private Path file(String name, String... lines) throws IOException {
        return Files.writeString(folder.resolve(name), String.join("\r\n", lines));
    }

    @Test
    void aParamsFileGivesTheUnitsOfItsType() throws IOException {
        Path file = file(
                "rover.p",
                "ConfigVersion 2.0",
                "; Robot parameter file",
                "Section General settings",
                "Class Pioneer            ; general type of robot",
                "Subclass rover9 ; specific type",
                "MaxRVelocity 60          ; absolute maximum degrees / sec",
                "MaxVelocity 300",
                "AngleConvFactor 0.00153  ; radians per angular unit (2PI/4096)",
                "DistConvFactor 1.25000   ; multiplier to mm from robot units",
                "RangeConvFactor 0.5",
                "SonarUnit 0 69 136 90");
        RobotParameters read = RobotParameters.read(file);
        RobotKind kind = new RobotKind(1.25, 0.5, 4096, 1, 300, 60);
        assertEquals(new RobotParameters("rover9", kind), read);
        FakePioneer fake = new FakePioneer("Rover9", kind, Manner.PROMPT, Optional.of(read));
        assertEquals(RobotStatus.STOPPED, fake.robot.status());
        drives(fake, 100);
        turns(fake, 90);
    }

    @Test
    void aParamsFileOfAnotherTypeDoesNotMakeARobotKnown() throws IOException {
        RobotParameters read = RobotParameters.read(file("rover.p", "DistConvFactor 1.25"));
        assertEquals("rover", read.subclass());
        FakePioneer fake =
                new FakePioneer("tank", RobotKind.named("p3dx").orElseThrow(), Manner.PROMPT, Optional.of(read));
        assertEquals(RobotStatus.NO_MOTORS, fake.robot.status());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "Section Conversion factors", "DistConvFactor x", "DistConvFactor -1", "DistConvFactor NaN"})
    void aFileThatDescribesNoRobotSaysWhatWasExpected(String text) throws IOException {
        Path file = file("bad.p", text);
        IOException refused = assertThrows(IOException.class, () -> RobotParameters.read(file));
        assertTrue(refused.getMessage().contains("bad.p: "), refused.getMessage());
        assertTrue(refused.getMessage().contains("expected"), refused.getMessage());
    }

    /** 256 to 65536 units per turn: the robots' answers have 16 bits for the heading. */
    @ParameterizedTest
    @ValueSource(strings = {"10", "999999", "0.05", "0.00001"})
    void anAngleThatMakesNoTurnIsRefused(String factor, @TempDir Path folder) throws IOException {
        Path file = folder.resolve("rover.p");
        Files.write(file, List.of("DistConvFactor 1", "AngleConvFactor " + factor));
        IOException refusal = assertThrows(IOException.class, () -> RobotParameters.read(file));
        assertEquals(
                file + ": AngleConvFactor " + factor + ", expected 0.0000959 to 0.0245 (65536 to 256 units per turn)",
                refusal.getMessage());
    }

    @ParameterizedTest
    @CsvSource({"0.0000959, 65536", "0.0245, 256", "0.001534, 4096"})
    void theLeastAndTheLargestAngleAreTaken(String factor, int unitsPerTurn, @TempDir Path folder) throws IOException {
        Path file = folder.resolve("rover.p");
        Files.write(file, List.of("DistConvFactor 1", "AngleConvFactor " + factor));
        assertEquals(unitsPerTurn, RobotParameters.read(file).kind().unitsPerTurn());
    }
}
