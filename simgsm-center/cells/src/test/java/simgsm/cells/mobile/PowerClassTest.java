package simgsm.cells.mobile;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.octets.OctetString;

class PowerClassTest {
    /** Class 1 of DCS 1800 is 0, class 4 of GSM 900 is 3 (TS 24.008, 10.5.1.5). */
    @ParameterizedTest
    @CsvSource({
        "600, 05087000f110fffe3308091010, 05087000f110fffe3008091010",
        "100, 05087000f110fffe3308091010, 05087000f110fffe3308091010",
        "885, 05247103331981, 05247103301981",
        "512, 06270003331981, 06270003301981",
        "700, 05013308091010, 05013008091010",
        "700, 052803, 052803",
        "700, 0524, 0524",
        "700, 05, 05"
    })
    void theFirstMessageNamesTheClassOfTheBand(int arfcn, String sent, String received) {
        assertEquals(OctetString.ofHex(received), PowerClass.in(arfcn, OctetString.ofHex(sent)));
    }
}
