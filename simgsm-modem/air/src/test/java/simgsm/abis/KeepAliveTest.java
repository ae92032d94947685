package simgsm.abis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.timer.Timers;

class KeepAliveTest {
    private static final String PING = "Ping";

    private final Timers timers = new Timers();
    private final List<String> done = new ArrayList<>();
    private final KeepAlive keepAlive =
            new KeepAlive(timers, message -> done.add(message.getClass().getSimpleName()), done::add);

    private void periods(int count) {
        timers.advance(timers.nowNanos() + count * KeepAlive.PERIOD_NANOS);
    }

    @Test
    void thirtySecondsPassBeforeTheFirstPing() {
        keepAlive.start();
        timers.advance(KeepAlive.PERIOD_NANOS - 1);
        assertEquals(List.of(), done);
        timers.advance(KeepAlive.PERIOD_NANOS);
        assertEquals(List.of(PING), done);
    }

    @Test
    void aSilentPeerIsGivenUpWhenTheFourthPingFallsDue() {
        keepAlive.start();
        periods(3);
        assertEquals(Collections.nCopies(3, PING), done);
        periods(10);
        assertEquals(List.of(PING, PING, PING, "3 pings unanswered"), done);
    }

    @Test
    void aPongOrAnythingHeardBeginsTheCountAgain() {
        keepAlive.start();
        periods(3);
        keepAlive.receive(new CcmMessage.Pong());
        periods(3);
        keepAlive.heard();
        periods(3);
        assertEquals(Collections.nCopies(9, PING), done);
    }

    @Test
    void aPingIsAnsweredAndIsNoAnswer() {
        keepAlive.start();
        periods(3);
        keepAlive.receive(new CcmMessage.Ping());
        keepAlive.receive(new CcmMessage.IdentityRequest());
        periods(1);
        assertEquals(List.of(PING, PING, PING, "Pong", "3 pings unanswered"), done);
    }

    @Test
    void aNewConnectionStartsAnewAndAStoppedOneIsSilent() {
        keepAlive.start();
        periods(3);
        keepAlive.start();
        periods(3);
        assertEquals(Collections.nCopies(6, PING), done);
        keepAlive.stop();
        periods(5);
        assertEquals(Collections.nCopies(6, PING), done);
    }
}
