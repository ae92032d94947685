package simgsm.center.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.UnknownHostException;
import org.junit.jupiter.api.Test;

class AdmissionsTest {
    private static InetAddress remote(int host) {
        try {
            return InetAddress.getByAddress(new byte[] {(byte) 192, 0, 2, (byte) host});
        } catch (UnknownHostException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void oneAddressCannotTakeAllThePlaces() {
        ConnectionLimits admissions =
                new ConnectionLimits(CenterLoop.MAX_CONNECTIONS, CenterLoop.MAX_CONNECTIONS_PER_ADDRESS);
        for (int i = 0; i < CenterLoop.MAX_CONNECTIONS_PER_ADDRESS; i++) {
            assertTrue(admissions.admit(remote(1)));
        }
        assertFalse(admissions.admit(remote(1)));
        assertTrue(admissions.admit(remote(2)), "the others are not its fault");
        admissions.left(remote(1));
        assertTrue(admissions.admit(remote(1)));
    }

    @Test
    void thisMachineMayHaveThemAllAndNoMore() {
        ConnectionLimits admissions = new ConnectionLimits(2_000, 1);
        for (int i = 0; i < 2_000; i++) {
            assertTrue(admissions.admit(InetAddress.getLoopbackAddress()));
        }
        assertFalse(admissions.admit(InetAddress.getLoopbackAddress()));
        assertFalse(admissions.admit(remote(1)));
        admissions.left(InetAddress.getLoopbackAddress());
        assertTrue(admissions.admit(remote(1)));
        assertEquals(2_000, admissions.open());
    }
}
