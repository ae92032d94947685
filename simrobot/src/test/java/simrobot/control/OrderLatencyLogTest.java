package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import vericommand.OrderText;
import vericommand.RobotStatus;
import vericommand.Verdict;

class OrderLatencyLogTest {
    private long nowNanos;
    private final OrderLatencyLog stopwatch = new OrderLatencyLog("robot", () -> nowNanos);

    private static Verdict verdict(String order) {
        return Verdict.of(OrderText.read(order), RobotStatus.STOPPED);
    }

    @Test
    void theWayFromTheLastKeyToTheWheelsIsMeasuredOnce() {
        stopwatch.keyBegan(1_000_000_000L);
        stopwatch.order(verdict("** #**20 **"));
        stopwatch.noKey();
        nowNanos = 1_062_400_000L;
        assertEquals(62, stopwatch.wheelsMoved());
        assertEquals(-1, stopwatch.wheelsMoved(), "the next instruction of a trip is not measured");
    }

    @Test
    void ordersWithoutMotionOrWithoutKeysAreNotMeasured() {
        stopwatch.keyBegan(0);
        stopwatch.order(verdict("** #*0 **"));
        assertEquals(-1, stopwatch.wheelsMoved());
        stopwatch.noKey();
        stopwatch.order(verdict("** #**20 **"));
        assertEquals(-1, stopwatch.wheelsMoved());
    }

    @Test
    void anOrderThatEndsBeforeTheWheelsMoveIsNotMeasuredLater() {
        stopwatch.keyBegan(0);
        stopwatch.order(verdict("** #**20 **"));
        stopwatch.orderEnded();
        assertEquals(-1, stopwatch.wheelsMoved());
    }
}
