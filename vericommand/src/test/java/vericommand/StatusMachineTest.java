package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.state.StateTable;

class StatusMachineTest {
    static Stream<Arguments> everyStateWithEveryEvent() {
        return Stream.of(RobotStatus.values())
                .flatMap(status -> Stream.of(StatusEvent.values()).map(event -> Arguments.of(status, event)));
    }

    @ParameterizedTest
    @MethodSource("everyStateWithEveryEvent")
    void anEventIsMadeIfTheTableListsItAndElseRefusedWithoutAChange(RobotStatus from, StatusEvent event) {
        StatusMachine machine = new StatusMachine(from);
        if (machine.accepts(event)) {
            assertEquals(StatusMachine.TABLE.row(from, event).orElseThrow().next(), machine.apply(event));
        } else {
            IllegalStateException refusal = assertThrows(IllegalStateException.class, () -> machine.apply(event));
            assertTrue(refusal.getMessage().contains(from.text()), refusal.getMessage());
            assertTrue(refusal.getMessage().contains(event.text()), refusal.getMessage());
            assertEquals(from, machine.status());
        }
    }

    @ParameterizedTest
    @CsvSource({
        "DISCONNECTED, POWER_ON, NO_MOTORS",
        "NO_MOTORS, MOTORS_ON, STOPPED",
        "STOPPED, MOTION_STARTED, MOVING",
        "COLLISION, MOTION_STARTED, MOVING",
        "MOVING, MOTION_ENDED, STOPPED",
        "MOVING, TOUCHED, COLLISION",
        "MOVING, TURN_ENDED_BLOCKED, COLLISION",
        "COLLISION, MOTORS_OFF, NO_MOTORS",
        "MOVING, MOTORS_OFF, NO_MOTORS",
        "STOPPED, MOTORS_OFF, NO_MOTORS",
        "NO_MOTORS, MOTORS_OFF, NO_MOTORS",
        "DISCONNECTED, MOTORS_OFF, DISCONNECTED",
        "COLLISION, POWER_OFF, DISCONNECTED",
        "MOVING, POWER_OFF, DISCONNECTED",
        "STOPPED, POWER_OFF, DISCONNECTED",
        "NO_MOTORS, POWER_OFF, DISCONNECTED",
        "DISCONNECTED, POWER_OFF, DISCONNECTED"
    })
    void theSpecifiedTransitionsAreMade(RobotStatus from, StatusEvent event, RobotStatus to) {
        assertEquals(to, new StatusMachine(from).apply(event));
    }

    @Test
    void thereAreNoOtherTransitionsAndNoneTwice() {
        Set<String> rows = new HashSet<>();
        StatusMachine.TABLE.rows().forEach(row -> assertTrue(rows.add(row.state() + " " + row.event()), row::toString));
        assertEquals(17, rows.size());
    }

    @Test
    void aRobotThatIsOffOrWithoutMotorsCannotMove() {
        assertFalse(new StatusMachine(RobotStatus.DISCONNECTED).accepts(StatusEvent.MOTION_STARTED));
        assertFalse(new StatusMachine(RobotStatus.NO_MOTORS).accepts(StatusEvent.MOTION_STARTED));
        assertFalse(new StatusMachine(RobotStatus.DISCONNECTED).accepts(StatusEvent.MOTORS_ON));
    }

    @Test
    void theDiagramShowsEveryStatusAndEveryTransition() {
        String uml = StatusMachine.TABLE.plantUml();
        assertTrue(uml.startsWith("@startuml\n") && uml.endsWith("@enduml\n"), uml);
        for (RobotStatus status : RobotStatus.values()) {
            assertTrue(uml.contains("state \"" + status.text() + "\" as " + status.name() + "\n"), uml);
        }
        for (StateTable.Row<RobotStatus, StatusEvent, StateTable.NoAction> row : StatusMachine.TABLE.rows()) {
            String arrow = row.state() + " --> " + row.next() + " : ";
            assertTrue(
                    row.state() == row.next()
                            || uml.lines()
                                    .anyMatch(line -> line.startsWith(arrow)
                                            && line.contains(row.event().text())),
                    uml);
        }
    }

    @Test
    void theDiagramInTheDocumentsIsPrintedFromThisTable() throws IOException {
        String drawn = Files.readString(Path.of("..", "docs", "uml", "status.puml"));
        assertEquals(StatusMachine.TABLE.plantUml(), drawn.replace("\r", ""));
    }

    @ParameterizedTest
    @CsvSource({
        "Collision,COLLISION",
        "Moving,MOVING",
        "Stopped,STOPPED",
        "No motors,NO_MOTORS",
        "Disconnected,DISCONNECTED",
        "no-motors,NO_MOTORS",
        "NoMotors,NO_MOTORS",
        "stopped,STOPPED"
    })
    void aStatusIsFoundByItsWords(String text, RobotStatus status) {
        assertEquals(status, RobotStatus.ofText(text));
    }

    @Test
    void anUnknownStatusIsRefusedNamingTheFive() {
        String message = assertThrows(IllegalArgumentException.class, () -> RobotStatus.ofText("Flying"))
                .getMessage();
        for (RobotStatus status : RobotStatus.values()) {
            assertTrue(message.contains(status.text()), message);
        }
    }
}
