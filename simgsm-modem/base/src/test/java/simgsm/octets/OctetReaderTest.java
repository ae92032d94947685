package simgsm.octets;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class OctetReaderTest {
    private static OctetReader<Exception> reader(String hex) {
        return new OctetReader<>(OctetString.ofHex(hex).toArray(), Exception::new);
    }

    private static String hex(OctetWriter writer) {
        return OctetString.of(writer.toArray()).toString();
    }

    private static void assertRefused(String text, Executable read) {
        assertEquals(text, assertThrows(Exception.class, read).getMessage());
    }

    @Test
    void numbersHaveTheirHighestOctetFirst() throws Exception {
        OctetReader<Exception> in = reader("ff0102fffffffe8000000000000001");
        assertEquals(0xff, in.octet("a"));
        assertEquals(0x0102, in.twoOctets("b"));
        assertEquals(0xfffffffeL, in.fourOctets("c"));
        assertEquals(Long.MIN_VALUE + 1, in.eightOctets("d"));
        assertFalse(in.hasMore());
    }

    @Test
    void aLittleEndianWriterHasTheLowestOctetFirst() {
        OctetWriter out = new OctetWriter(ByteOrder.LITTLE_ENDIAN);
        assertEquals("0102010403feff", hex(out.octet(1).twoOctets(0x0102).twoOctets(0x0304, -2)));
    }

    @Test
    void aFieldThatIsTooShortIsRefusedByItsName() {
        OctetReader<Exception> in = reader("01");
        assertRefused("length needs 2 octets, 1 are left", () -> in.twoOctets("length"));
        assertEquals(1, in.remaining());
    }

    @ParameterizedTest
    @CsvSource({"0, 00", "127, 7f", "128, 8001", "300, ac02", "-1, ffffffffffffffffff01"})
    void compactNumbersAreLeb128(long number, String octets) throws Exception {
        assertEquals(octets, hex(new OctetWriter().compact(number)));
        assertEquals(number, reader(octets).compact());
    }

    @Test
    void aCompactNumberThatDoesNotEndIsRefused() {
        assertRefused(
                "a number has over 10 octets",
                () -> reader("ffffffffffffffffffff01").compact());
    }

    @Test
    void realNumbersAndTextsAreReadAsWritten() throws Exception {
        OctetReader<Exception> in =
                reader(hex(new OctetWriter().real(-0.1).text("ñ").zeroEnded("ñ")));
        assertEquals(-0.1, in.real());
        assertEquals("ñ", in.text());
        assertEquals("f100", in.rest().toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"02ff", "ffffffff0f"})
    void aListCountsNoMoreItemsThanOctetsAreLeft(String octets) {
        assertThrows(Exception.class, () -> reader(octets).count());
    }

    @Test
    void aLengthOctetCountsWhatFollowsIt() {
        OctetWriter out = new OctetWriter();
        int length = out.openLength();
        assertEquals("03010203", hex(out.octet(1).twoOctets(0x0203).closeLength(length)));
        int second = out.openLength();
        out.bytes(new byte[256]);
        assertThrows(IllegalArgumentException.class, () -> out.closeLength(second));
    }
}
