package simgsm.air;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Emergency numbers are dialled whole (TS 22.101, 10.1). */
class EmergencyNumberTest {
    /** 911 and seven digits: what the network shows for a caller without a number (J-STD-036, annex C). */
    @ParameterizedTest
    @CsvSource({"112, true", "911, true", "9111234567, false", "1120, false", "0112, false", "91, false", "110, false"})
    void onlyTheNumberAloneCallsForHelp(String digits, boolean isEmergency) {
        assertEquals(isEmergency, new Msisdn(digits).isEmergency());
    }
}
