package simgsm.air;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.octets.OctetString;

class ElementTableTest {
    @Test
    void aRowHasTheCellsOfTheStandardsTable() {
        assertEquals(
                List.of("5E", "Called party BCD number", "Called party BCD number 10.5.4.7", "M", "TLV", "3-43"),
                Layer3Type.SETUP.elements(Direction.UPLINK).get(1).cells());
        assertEquals(
                List.of("", "Ciphering key sequence number", "Ciphering key sequence number 10.5.1.2", "M", "V", "1/2"),
                Layer3Type.PAGING_RESPONSE.elements(Direction.UPLINK).get(0).cells());
    }

    @Test
    void aRowThatNamesNoComponentIsRefused() {
        Element row = Element.row(ElementType.RR_CAUSE, Element.Presence.M, Element.Format.V, 1)
                .to("reason");

        assertThrows(
                IllegalArgumentException.class,
                () -> new ElementTable(RadioResource.ChannelRelease.class, List.of(row)));
    }

    @Test
    void valuesAndLengthsOutOfRangeAreNotSent() {
        refused(new RadioResource.RrStatus(256));
        refused(new MobilityManagement.AuthenticationRequest(8, octets(16), Optional.empty()));
        refused(new MobilityManagement.AuthenticationRequest(0, octets(15), Optional.empty()));
        refused(new MobilityManagement.AuthenticationRequest(0, octets(16), Optional.of(octets(15))));
        refused(new CallControl.Facility(Examples.ours(0), octets(256)));
    }

    @Test
    void aBearerCapabilityInCallConfirmedIsNoCause() throws ProtocolViolation {
        byte[] octets =
                OctetString.ofHex("8308" + "0406600402000581" + "15020100").toArray();

        assertEquals(new CallControl.CallConfirmed(Examples.theirs(0)), Layer3Codec.decode(octets, Direction.UPLINK));
    }

    /** Most types are read of some random values; all others are refused with a violation. */
    @ParameterizedTest
    @EnumSource
    void randomMessagesAreReadOrRefused(Direction direction) {
        Random random = new Random(24007);
        Set<Layer3Type> read = EnumSet.noneOf(Layer3Type.class);
        for (int i = 0; i < 20_000; i++) {
            byte[] octets = Layer3Codec.random(random, direction);
            try {
                read.add(Layer3Type.of(Layer3Codec.decode(octets, direction)));
            } catch (ProtocolViolation violation) {
                assertTrue(violation.header().isPresent(), violation.getMessage());
            }
        }
        List<Layer3Type> sent = Stream.of(Layer3Type.values())
                .filter(type -> type.goes(direction))
                .toList();
        assertTrue(sent.containsAll(read), read.toString());
        assertTrue(read.size() > sent.size() * 3 / 4, read.size() + " of " + sent.size() + " types are read");
    }

    private static void refused(Layer3Message message) {
        assertThrows(IllegalArgumentException.class, () -> Layer3Codec.encode(message, Direction.DOWNLINK, 0));
    }

    private static OctetString octets(int count) {
        return OctetString.of(new byte[count]);
    }
}
