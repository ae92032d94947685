package simgsm.center.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.center.msc.ExchangeSnapshot;

class RatesTest {
    private static final long SECOND = 1_000_000_000;

    private final Rates rates = new Rates();

    private static ExchangeSnapshot passed(long messages, long frames) {
        return new ExchangeSnapshot(
                Scene.NOON,
                0,
                0,
                0,
                frames,
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                messages,
                Optional.empty(),
                List.of(),
                List.of());
    }

    @Test
    void nothingIsKnownBeforeTheSecondLook() {
        rates.saw(passed(1_000, 1_000));
        rates.tick(5 * SECOND);
        assertEquals(0, rates.messagesPerSecond());
        assertEquals(0, rates.framesPerSecond());
    }

    @Test
    void whatPassedBetweenTwoLooksCountsByTheSecond() {
        rates.saw(passed(1_000, 2_000));
        rates.tick(SECOND);
        rates.saw(passed(1_010, 2_050));
        rates.saw(passed(1_020, 2_100));
        rates.tick(3 * SECOND);
        assertEquals(10, rates.messagesPerSecond());
        assertEquals(50, rates.framesPerSecond());
    }

    @Test
    void whenNothingPassesTheRateFallsToNothing() {
        rates.tick(SECOND);
        rates.saw(passed(10, 10));
        rates.tick(2 * SECOND);
        assertEquals(10, rates.messagesPerSecond());
        rates.tick(3 * SECOND);
        assertEquals(0, rates.messagesPerSecond());
    }
}
