package simgsm.rr;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

class FrequencyListTest {
    /** The format bits of the first octet, by format; in range 1024 the last one tells of ARFCN 0. */
    @ParameterizedTest
    @CsvSource({
        "00, 1 120 50",
        "00, 110",
        "8e, 600",
        "8e, 0 111",
        "8e, 512 600 623",
        "8c, 512 639",
        "8a, 600 800",
        "8a, 600 855",
        "88, 512 885",
        "80, 110 975",
        "84, 0 700",
        "8e, 0 1023",
        "8e, 975 40",
        "80, 110 700 975"
    })
    void theMostCompactFormatWithRoomIsTaken(String firstOctet, String arfcns) throws ProtocolViolation {
        List<Integer> set = Stream.of(arfcns.split(" ")).map(Integer::valueOf).toList();
        OctetString octets = FrequencyList.encode(set);

        int format = octets.octet(0) & ((octets.octet(0) & 0x88) == 0x80 ? 0x8c : 0x8e);
        assertEquals(firstOctet, String.format("%02x", format));
        assertEquals(
                set.stream().sorted(FrequencyList.ORDER).toList(), FrequencyList.decode(octets), octets.toString());
    }

    @ParameterizedTest
    @ValueSource(ints = {0x00, 0x10, 0x20, 0x30})
    void theBitsOfNeighbourListsDoNotChangeTheFrequencies(int bits) throws ProtocolViolation {
        for (List<Integer> set : List.of(List.of(3, 7), List.of(512, 600), List.of(512, 885), List.of(1, 1023))) {
            byte[] octets = FrequencyList.encode(set).toArray();
            octets[0] |= (byte) bits;
            assertEquals(set, FrequencyList.decode(OctetString.of(octets)));
        }
    }

    @Test
    void randomSetsOfEachSpanAreReadBack() throws ProtocolViolation {
        Random random = new Random(1);
        for (int i = 0; i < 2_000; i++) {
            int span = 2 << random.nextInt(10);
            int count = 1 + random.nextInt(FrequencyList.SURE);
            int first = random.nextInt(1025 - span);
            TreeSet<Integer> set = IntStream.range(0, count)
                    .mapToObj(each -> first + random.nextInt(span))
                    .collect(Collectors.toCollection(TreeSet::new));
            assertEquals(
                    set.stream().sorted(FrequencyList.ORDER).toList(),
                    FrequencyList.decode(FrequencyList.encode(set)),
                    set.toString());
        }
    }

    @Test
    void aListWithoutRoomIsRefusedByNumberAndFrequencies() {
        List<Integer> spread = IntStream.range(0, 17).mapToObj(i -> 1 + 60 * i).toList();

        String told = assertThrows(IllegalArgumentException.class, () -> FrequencyList.encode(spread))
                .getMessage();
        assertTrue(told.contains("17 ARFCNs [1, 61,"), told);
    }

    @Test
    void anyOctetsAreRead() throws ProtocolViolation {
        Random random = new Random(2);
        for (int i = 0; i < 5_000; i++) {
            byte[] octets = new byte[16];
            random.nextBytes(octets);
            List<Integer> arfcns = FrequencyList.decode(OctetString.of(octets));
            assertTrue(arfcns.stream().allMatch(arfcn -> arfcn >= 0 && arfcn < 1024), arfcns.toString());
        }
    }
}
