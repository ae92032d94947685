package simgsm.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import simgsm.octets.OctetString;

/** Test sets of TS 35.208 by their numbers there; the GSM values of most of them stand in TS 55.205. */
class MilenageTest {
    @ParameterizedTest(name = "set {0}")
    @CsvFileSource(resources = "milenage.csv", numLinesToSkip = 1)
    void theStandardsTestSetsComeOut(
            int set,
            String k,
            String rand,
            String sqn,
            String amf,
            String op,
            String opc,
            String f1,
            String f1Star,
            String f2,
            String f3,
            String f4,
            String f5,
            String f5Star,
            String sres,
            String kc) {
        assertEquals(opc, Milenage.opc(hex(k), hex(op)).toString());
        Milenage functions = new Milenage(hex(k), hex(opc));
        assertEquals(f1, functions.f1(hex(rand), hex(sqn), hex(amf)).toString());
        assertEquals(f1Star, functions.f1Star(hex(rand), hex(sqn), hex(amf)).toString());
        assertEquals(f2, functions.f2(hex(rand)).toString());
        assertEquals(f3, functions.f3(hex(rand)).toString());
        assertEquals(f4, functions.f4(hex(rand)).toString());
        assertEquals(f5, functions.f5(hex(rand)).toString());
        assertEquals(f5Star, functions.f5Star(hex(rand)).toString());
        GsmVector gsm = GsmVector.of(functions, hex(rand));
        assertEquals(sres, gsm.sres().toString());
        assertEquals(kc, gsm.kc().toString());
    }

    @Test
    void aKeyOfTheWrongLengthIsRefusedByName() {
        OctetString key = hex("465b5ce8b199b49faa5f0a2ee238a6bc");
        IllegalArgumentException refused =
                assertThrows(IllegalArgumentException.class, () -> new Milenage(hex("00"), key));
        assertEquals("K has 1 octets, 16 were expected", refused.getMessage());
        Milenage functions = new Milenage(key, key);
        assertEquals(
                "RAND has 2 octets, 16 were expected",
                assertThrows(IllegalArgumentException.class, () -> functions.f2(hex("0102")))
                        .getMessage());
    }

    private static OctetString hex(String digits) {
        return OctetString.ofHex(digits);
    }
}
