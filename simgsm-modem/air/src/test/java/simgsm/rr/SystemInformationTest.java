package simgsm.rr;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.LocationArea;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.rr.SystemInformation.ControlChannel;
import simgsm.rr.SystemInformation.Neighbours;
import simgsm.rr.SystemInformation.RandomAccess;
import simgsm.rr.SystemInformation.Reselection;
import simgsm.rr.SystemInformation.SelectionParameters;
import simgsm.rr.SystemInformation.Type3;
import simgsm.rr.SystemInformation.Type6;

class SystemInformationTest {
    private static final RandomAccess ACCESS = new RandomAccess(7, 12, false);

    private static Type3 cell(Optional<Reselection> reselection) {
        return new Type3(
                6969,
                new LocationArea("001", "01", 7),
                new ControlChannel(true, 1, true, 5, 5),
                32,
                new SelectionParameters(4, 15, 0),
                ACCESS,
                reselection);
    }

    @Test
    void everyTypeIsReadBack() throws ProtocolViolation {
        for (SystemInformation information : List.of(
                new Neighbours(NeighbourList.TYPE_2_BIS, List.of(100, 110)),
                cell(Optional.empty()),
                cell(Optional.of(new Reselection(10, 30, 40))),
                cell(Optional.of(new Reselection(0, Double.POSITIVE_INFINITY, -1))),
                new Neighbours(NeighbourList.TYPE_5_TER, List.of(512, 540)),
                new Type6(6970, LocationArea.TEST, 64))) {
            assertEquals(Optional.of(information), SystemInformation.decode(information.encode()));
        }
    }

    /** The octets that osmo-bsc 1.9 sends for a neighbour of ARFCN 110, and for two. */
    @Test
    void aBitMapCountsFrequenciesFromTheEnd() throws ProtocolViolation {
        OctetString one = OctetString.ofHex("00002000000000000000000000000000");

        assertEquals(List.of(110), FrequencyList.decode(one));
        assertEquals(one, FrequencyList.encode(List.of(110)));
    }

    @Test
    void aMobileOfACombinedCellHasOneOfTenPagingGroups() {
        assertEquals(10, new ControlChannel(true, 1, true, 5, 0).pagingGroups());
        assertEquals(81, new ControlChannel(true, 0, false, 9, 0).pagingGroups());
    }

    @Test
    void aRequestReferenceHasTheFrameInThreeParts() throws ProtocolViolation {
        RequestReference reference = RequestReference.at(0xe3, 42_432L * 9 + 1_326 * 3 + 50);

        assertEquals("e31e58", reference.octets().toString());
        assertEquals(reference, RequestReference.of(reference.octets()));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "49",
                "49061b",
                "49061b1b3900f110",
                "49061d8000",
                "4906 1b1b39ffffff00014900000000",
                // Combined common channels, all 7 blocks for access grant.
                "4906 1b1b3900f1100001790305274e40e50400292b2b2b"
            })
    void brokenInformationIsRefused(String hex) {
        assertThrows(ProtocolViolation.class, () -> SystemInformation.decode(OctetString.ofHex(hex.replace(" ", ""))));
    }
}
