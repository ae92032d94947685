package simgsm.classroom.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.InetAddress;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ClassAddressesTest {
    private static final List<String> ALL = List.of("172.17.0.1", "192.168.1.5", "10.8.0.2");

    @Test
    void theAddressOfTheWayOutIsFirst() {
        assertEquals(
                List.of("192.168.1.5", "172.17.0.1", "10.8.0.2"),
                ClassAddresses.inOrder(Optional.of("192.168.1.5"), ALL));
        assertEquals(ALL, ClassAddresses.inOrder(Optional.empty(), ALL));
        assertEquals(ALL, ClassAddresses.inOrder(Optional.of("0.0.0.0"), ALL));
    }

    @Test
    void aMachineWithoutANetworkHasItsOwnAddress() {
        assertEquals(List.of("127.0.0.1"), ClassAddresses.inOrder(Optional.empty(), List.of()));
    }

    @Test
    void theAddressOfBindIsTheOnlyOne() throws Exception {
        assertEquals(List.of("127.0.0.5"), ClassAddresses.of(InetAddress.getByName("127.0.0.5")));
    }
}
