package simgsm.octets;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NetworkNameTest {
    private static String read(String hex) {
        byte[] octets = OctetString.ofHex(hex).toArray();
        return NetworkName.read(octets[0] & 0xff, Arrays.copyOfRange(octets, 1, octets.length));
    }

    @ParameterizedTest
    @CsvSource({"SimGSM, 86d374fb386d02", "A, 8141", "Año, 90004100f1006f", "移动, 9079fb52a8"})
    void isSeptetsWhereTheAlphabetsAgreeElseUcs2(String name, String hex) {
        OctetWriter out = new OctetWriter();
        NetworkName.write(out, name);

        assertEquals(hex, out.toOctetString().toString());
        assertEquals(name, read(hex));
    }

    @ParameterizedTest
    @CsvSource({"90000a0041, ?A", "9000410a, A", "8700, ''", "80, ''"})
    void ofForeignOctetsHasNoControlCharacter(String hex, String name) {
        assertEquals(name, read(hex));
    }
}
