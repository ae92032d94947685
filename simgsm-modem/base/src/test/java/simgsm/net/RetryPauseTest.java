package simgsm.net;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class RetryPauseTest {
    @Test
    void pausesDoubleUpToTheLongestAndBeginAgainAfterAReset() {
        RetryPause pause = new RetryPause(200, 1_000);
        assertEquals(200, pause.next());
        assertEquals(400, pause.next());
        assertEquals(800, pause.next());
        assertEquals(1_000, pause.next());
        assertEquals(1_000, pause.next());
        pause.reset();
        assertEquals(200, pause.next());
    }
}
