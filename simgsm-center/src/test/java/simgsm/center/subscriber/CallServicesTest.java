package simgsm.center.subscriber;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.Msisdn;
import simgsm.ss.SsCode;

/** What the centre keeps of a subscriber's services. */
class CallServicesTest {
    private final CallServices services = new CallServices();

    @Test
    void forwardingAndCallWaitingAreRestored() {
        services.register(SsCode.FORWARDING_ON_BUSY, new Msisdn("5550102"));
        services.register(SsCode.FORWARDING_UNCONDITIONAL, new Msisdn("5550103"));
        services.setForwarding(SsCode.FORWARDING_UNCONDITIONAL, false);
        services.setCallWaiting(true);
        CallServices again = new CallServices();
        again.restore(services.text());
        assertEquals(services.text(), again.text());
        assertEquals(Optional.of(new Msisdn("5550102")), again.forwarding(SsCode.FORWARDING_ON_BUSY));
        assertEquals(Optional.empty(), again.forwarding(SsCode.FORWARDING_UNCONDITIONAL));
        assertEquals(6, again.status(SsCode.FORWARDING_UNCONDITIONAL).flags());
        assertEquals(true, again.hasCallWaiting(false));
    }

    @Test
    void whoHasSetNothingHasNoText() {
        assertEquals("", services.text());
        services.restore("");
        assertEquals(false, services.hasCallWaiting(false));
        assertEquals(true, services.hasCallWaiting(true));
    }

    @ParameterizedTest
    @ValueSource(strings = {"x", "99=5550102,true", "21=", "21=abc,true"})
    void anotherTextIsRefused(String text) {
        assertThrows(IllegalArgumentException.class, () -> services.restore(text));
    }
}
