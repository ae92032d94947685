package simgsm.net;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.InetAddress;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ReachableAddressesTest {
    private static final List<String> ALL = List.of("172.17.0.1", "192.168.1.5", "10.8.0.2");

    @Test
    void theAddressOfTheWayOutIsFirst() {
        assertEquals(
                List.of("192.168.1.5", "172.17.0.1", "10.8.0.2"),
                ReachableAddresses.inOrder(Optional.of("192.168.1.5"), ALL));
        assertEquals(ALL, ReachableAddresses.inOrder(Optional.empty(), ALL));
        assertEquals(ALL, ReachableAddresses.inOrder(Optional.of("0.0.0.0"), ALL));
    }

    @Test
    void aMachineWithoutANetworkHasItsOwnAddress() {
        assertEquals(List.of("127.0.0.1"), ReachableAddresses.inOrder(Optional.empty(), List.of()));
    }

    @Test
    void theAddressOfBindIsTheOnlyOne() throws Exception {
        assertEquals(List.of("127.0.0.5"), ReachableAddresses.of(InetAddress.getByName("127.0.0.5")));
    }
}
