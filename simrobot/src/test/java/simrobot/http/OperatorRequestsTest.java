package simrobot.http;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.UUID;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import simgsm.web.RequestException;
import simgsm.web.WebResponse;

class OperatorRequestsTest {
    private static final UUID FORWARD = new UUID(1, 1);
    private static final UUID TURN = new UUID(2, 2);

    private final OperatorRequests requests = new OperatorRequests();
    private int performed;

    private PlacedOrder once(String key, UUID request, long nowNanos) throws Exception {
        return requests.once(
                key, request, () -> new PlacedOrder(WebResponse.json("" + ++performed), "/" + performed), nowNanos);
    }

    private static int status(RequestException refusal) {
        return refusal.status();
    }

    @Test
    void aKeyHasTheSameAnswerFor24HoursAndThenANewOne() throws Exception {
        PlacedOrder first = once("a", FORWARD, 0);
        assertSame(first, once("a", FORWARD, OperatorRequests.KEPT_NANOS - 1));
        assertEquals("/2", once("b", FORWARD, OperatorRequests.KEPT_NANOS - 1).location());
        assertEquals("/3", once("a", TURN, OperatorRequests.KEPT_NANOS).location());
        assertEquals("/2", once("b", FORWARD, OperatorRequests.KEPT_NANOS).location());
    }

    @Test
    void aKeyWithAnotherOrderIsRefused() throws Exception {
        once("a", FORWARD, 0);
        assertEquals(422, status(assertThrows(RequestException.class, () -> once("a", TURN, 1))));
        assertEquals(1, performed);
    }

    @Test
    void aRequestThatCouldNotBePerformedIsNotRemembered() throws Exception {
        assertThrows(
                IllegalStateException.class,
                () -> requests.once(
                        "a",
                        FORWARD,
                        () -> {
                            throw new IllegalStateException("the simulation does not answer");
                        },
                        0));
        assertEquals("/1", once("a", FORWARD, 1).location());
    }

    @Test
    void tenRequestsASecondAreTakenAndNoKeyMoreThanAreKept() throws Exception {
        for (int i = 0; i < OperatorRequests.PER_SECOND; i++) {
            requests.requireRate(0);
        }
        assertEquals(429, status(assertThrows(RequestException.class, () -> requests.requireRate(1))));
        requests.requireRate(TimeUnit.SECONDS.toNanos(1) / OperatorRequests.PER_SECOND);
        for (int i = 0; i < OperatorRequests.MOST_KEYS; i++) {
            once("" + i, FORWARD, 0);
        }
        assertEquals(429, status(assertThrows(RequestException.class, () -> once("more", FORWARD, 0))));
    }
}
