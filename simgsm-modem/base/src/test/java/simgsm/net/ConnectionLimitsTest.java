package simgsm.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.UnknownHostException;
import org.junit.jupiter.api.Test;

class ConnectionLimitsTest {
    private static InetAddress remote(int host) {
        try {
            return InetAddress.getByAddress(new byte[] {(byte) 192, 0, 2, (byte) host});
        } catch (UnknownHostException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void oneRemoteAddressHasItsOwnLimit() {
        ConnectionLimits limits = new ConnectionLimits(20_000, 500);
        for (int i = 0; i < 500; i++) {
            assertTrue(limits.admit(remote(1)));
        }
        assertFalse(limits.admit(remote(1)));
        assertTrue(limits.admit(remote(2)), "another address");
        limits.release(remote(1));
        assertTrue(limits.admit(remote(1)));
    }

    @Test
    void theReservedPlacesAreForThisMachineAndForAddressesThatHaveProvenThemselves() {
        ConnectionLimits limits = new ConnectionLimits(10, 10, 3);
        limits.proven(remote(2));
        for (int i = 0; i < 7; i++) {
            assertTrue(limits.admit(remote(1)));
        }
        assertFalse(limits.admit(remote(1)));
        assertFalse(limits.admit(remote(3)));
        assertTrue(limits.admit(remote(2)));
        assertTrue(limits.admit(InetAddress.getLoopbackAddress()));
        assertTrue(limits.admit(remote(2)));
        assertFalse(limits.admit(remote(2)), "all places are taken");
        limits.release(remote(1));
        assertFalse(limits.admit(remote(1)), "the reserve is full first");
        assertTrue(limits.admit(remote(2)));
    }

    @Test
    void thisMachineHasOnlyTheTotalLimit() {
        ConnectionLimits limits = new ConnectionLimits(2_000, 1);
        for (int i = 0; i < 2_000; i++) {
            assertTrue(limits.admit(InetAddress.getLoopbackAddress()));
        }
        assertFalse(limits.admit(InetAddress.getLoopbackAddress()));
        assertFalse(limits.admit(remote(1)));
        limits.release(InetAddress.getLoopbackAddress());
        assertTrue(limits.admit(remote(1)));
        assertEquals(2_000, limits.open());
    }
}
