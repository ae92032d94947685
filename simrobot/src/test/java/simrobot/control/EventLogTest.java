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
        log.add("anna", new RobotEvent.CallReceived("5550100"));
        now = 20;
        log.add("anna", new RobotEvent.StatusChanged(RobotStatus.MOVING));
        assertEquals(
                List.of(
                        new LoggedEvent(0, "anna", new RobotEvent.CallReceived("5550100")),
                        new LoggedEvent(20, "anna", new RobotEvent.StatusChanged(RobotStatus.MOVING))),
                log.newest());
    }

    @Test
    void theOldestMakeRoomAndTheNewestIsAlwaysThere() {
        for (int i = 0; i < RobotEventLog.CAPACITY + 5; i++) {
            log.add("anna", new RobotEvent.CallReceived(String.valueOf(i)));
        }
        assertEquals(RobotEventLog.CAPACITY, log.newest().size());
        assertEquals("5", log.newest().get(0).line().fields().get("from"));
        assertEquals(
                String.valueOf(RobotEventLog.CAPACITY + 4),
                log.newest().get(RobotEventLog.CAPACITY - 1).line().fields().get("from"));
    }

    @Test
    void theListStaysTheSameObjectWhileNothingHappens() {
        log.add("anna", new RobotEvent.CallReleased(16));
        assertSame(log.newest(), log.newest());
    }
}
