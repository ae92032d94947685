package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class SnapshotPollerTest {
    private String newest = "first";
    private final List<String> shown = new ArrayList<>();
    private final SnapshotPoller<String> poller = new SnapshotPoller<>(() -> newest, shown::add);

    private void look(int times) {
        for (int i = 0; i < times; i++) {
            poller.look();
        }
    }

    @Test
    void aSnapshotIsShownOnce() {
        assertTrue(poller.show());
        assertFalse(poller.show());
        newest = "second";
        assertTrue(poller.show());
        assertEquals(List.of("first", "second"), shown);
    }

    @Test
    void after80LooksInVainItLooksFiveTimesASecondUntilAKeyIsPressed() {
        look(80);
        assertEquals(25, poller.periodMillis());
        look(1);
        assertEquals(200, poller.periodMillis());
        poller.wake();
        assertEquals(25, poller.periodMillis());
        poller.stop();
    }

    @Test
    void aClockThatChangesOnceASecondEndsARestForFourLooksOnly() {
        look(81);
        newest = "second";
        look(4);
        assertEquals(25, poller.periodMillis());
        look(1);
        assertEquals(200, poller.periodMillis());
    }
}
