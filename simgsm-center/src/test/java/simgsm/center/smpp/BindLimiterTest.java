package simgsm.center.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;

/** Guessing a password: slow for each address, and of one line a minute in the log. */
class BindLimiterTest extends SmppStage {
    BindLimiterTest() {
        network.server.admit(SmppUsers.only(Map.of("robot", "secret")));
    }

    private TestCenter.Application bindFrom(String address, String password) {
        TestCenter.Application application = network.open(false, address);
        application.say(new SmppPdu.Bind(SmppCommand.BIND_TRANSCEIVER, 1, "robot", password, "", 0x34, ""));
        return application;
    }

    private static int status(TestCenter.Application application) {
        return application.last(SmppPdu.BindResponse.class).status();
    }

    /** In each second 100 new connections guess once; returns the number of guesses that were looked at. */
    private int guesses(int seconds) {
        List<TestCenter.Application> all = new ArrayList<>();
        for (int second = 0; second < seconds; second++) {
            for (int i = 0; i < 100; i++) {
                all.add(bindFrom("10.0.0.9:" + (1_000 + i), "guess" + i));
            }
            network.passSeconds(1);
        }
        return (int) all.stream()
                .filter(each -> !each.heard.isEmpty() && status(each) == SmppStatus.INVALID_PASSWORD)
                .count();
    }

    @Test
    void anAddressHasTenGuessesThenOneASecond() {
        assertEquals(BindLimiter.FREE_REFUSALS + 59, guesses(60), 1.0);
    }

    @Test
    void anotherAddressBindsMeanwhile() {
        guesses(5);
        assertEquals(SmppStatus.OK, status(bindFrom("10.0.0.8:1", "secret")));
    }

    @Test
    void theRightPasswordFromTheSameAddressWaitsForItsTurn() {
        for (int i = 0; i < BindLimiter.FREE_REFUSALS; i++) {
            assertEquals(SmppStatus.INVALID_PASSWORD, status(bindFrom("10.0.0.9:1", "guess")));
        }
        TestCenter.Application right = bindFrom("10.0.0.9:2", "secret");
        assertTrue(right.heard.isEmpty());
        network.passSeconds(1);
        assertEquals(SmppStatus.OK, status(right));
    }

    @Test
    void whoHasWaitedLongEnoughGuessesAtOnceAgain() {
        guesses(5);
        network.passSeconds(3_600);
        assertEquals(SmppStatus.INVALID_PASSWORD, status(bindFrom("10.0.0.9:1", "guess")));
        assertEquals(SmppStatus.OK, status(bindFrom("10.0.0.9:1", "secret")));
    }

    @Test
    void aConnectionThatLeavesWhileItsBindWaitsIsForgotten() {
        guesses(1);
        TestCenter.Application left = bindFrom("10.0.0.9:1", "secret");
        left.leave();
        network.passSeconds(30);
        assertEquals(0, network.server.boundSessions());
    }

    @Test
    void theLogHasOneLineAMinuteWithTheirNumber() {
        LogThrottle log = new LogThrottle();
        List<Integer> lines = new ArrayList<>();
        for (int second = 0; second <= 120; second++) {
            for (int i = 0; i < 100; i++) {
                int count = log.count(1, second * 1_000_000_000L);
                if (count > 0) {
                    lines.add(count);
                }
            }
        }
        assertEquals(List.of(1, 6_000, 6_000), lines);
    }
}
