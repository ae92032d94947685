package simgsm.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.air.Direction;
import simgsm.air.Examples;
import simgsm.air.Examples.Example;
import simgsm.octets.OctetString;

class FieldOctetsTest {
    static List<Example> examples() {
        return Examples.all();
    }

    @Test
    void aSetupsFieldsStandInTheirElementsWithIdentifierAndLength() {
        OctetString octets = OctetString.ofHex("13050401a05c0811819471000000105e0791947100000020");
        MessageText text = MessageText.ofLayer3(octets, Direction.DOWNLINK);

        assertEquals("{0}", text.octetsOf(field(text, "transaction")).toString());
        assertEquals(range(2, 5), text.octetsOf(field(text, "bearer capability")));
        assertEquals(range(5, 15), text.octetsOf(field(text, "calling")));
        assertEquals(range(15, 24), text.octetsOf(field(text, "called")));
        assertEquals(field(text, "called"), text.fieldAt(15));
        assertEquals(field(text, "called"), text.fieldAt(23));
        assertEquals(-1, text.fieldAt(1));
    }

    @Test
    void theSequenceNumberOfAnUplinkMessageIsABitOfItsType() {
        MessageText text = MessageText.ofLayer3(OctetString.ofHex("034f"), Direction.UPLINK);

        assertEquals("{1}", text.octetsOf(0).toString());
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyFieldOfAMessageThatCanBeReadStandsSomewhere(Example example) {
        MessageText text = MessageText.ofLayer3(OctetString.ofHex(example.hex()), example.direction());

        for (int i = 0; i < text.fields().size(); i++) {
            boolean isAbsence = text.fields().get(i).value().equals("false");
            assertEquals(
                    isAbsence,
                    text.octetsOf(i).isEmpty(),
                    text.name() + ", " + text.fields().get(i));
        }
        for (int octet = 2; octet < text.octets().length() && !text.fields().isEmpty(); octet++) {
            assertTrue(text.fieldAt(octet) >= 0 || text.fields().size() < 2, text.name() + ", octet " + octet);
        }
    }

    @Test
    void aMessageThatCannotBeReadHasFieldsWithoutOctets() {
        MessageText text = MessageText.ofLayer3(OctetString.ofHex("03352c45"), Direction.UPLINK);

        assertTrue(text.octetsOf(0).isEmpty());
        assertEquals(-1, text.fieldAt(2));
    }

    private static int field(MessageText text, String name) {
        return text.fields().stream().map(MessageText.Field::name).toList().indexOf(name);
    }

    private static BitSet range(int from, int to) {
        BitSet range = new BitSet();
        range.set(from, to);
        return range;
    }
}
