package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import org.junit.jupiter.api.Test;
import vericommand.RobotStatus;

class EventLogTest {
    private long now;
    private final RobotEventLog log = new RobotEventLog(() -> now);

    @Test
    void eventsAreKeptInTheirOrderWithTheirTime() {
        ControlListener anna = log.of("anna");
        anna.call("5550100");
        now = 20;
        anna.status(RobotStatus.MOVING);
        assertEquals(
                List.of(
                        new LoggedEvent(0, "anna", LoggedEvent.Kind.CALL, "5550100", ""),
                        new LoggedEvent(20, "anna", LoggedEvent.Kind.STATUS, "MOVING", "")),
                log.newest());
    }

    @Test
    void theOldestMakeRoomAndTheNewestIsAlwaysThere() {
        for (int i = 0; i < RobotEventLog.CAPACITY + 5; i++) {
            log.of("anna").call(String.valueOf(i));
        }
        assertEquals(RobotEventLog.CAPACITY, log.newest().size());
        assertEquals("5", log.newest().get(0).what());
        assertEquals(
                String.valueOf(RobotEventLog.CAPACITY + 4),
                log.newest().get(RobotEventLog.CAPACITY - 1).what());
    }

    @Test
    void theListStaysTheSameObjectWhileNothingHappens() {
        log.of("anna").released(16);
        assertSame(log.newest(), log.newest());
    }
}
