package simgsm.phone.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.ResourceBundle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.console.TextBundle;

class CauseTextTest {
    @ParameterizedTest
    @CsvSource({
        "en, 3, false, 5550100 is in use by another phone",
        "es, 3, false, otro tel\u00e9fono ya usa el 5550100",
        "en, 3, true, the network does not accept this SIM",
        "es, 3, true, la red no acepta esta SIM",
        "en, 2, false, the network does not know this SIM",
        "en, 6, false, the network has barred this phone",
        "es, 11, false, la red ha bloqueado esta SIM",
        "en, 22, false, refused by the network: congestion"
    })
    void whyTheNetworkRefusesThePhoneIsSaidInWords(String language, int code, boolean cardRefused, String words) {
        Locale locale = TextBundle.bundleLocale(Locale.forLanguageTag(language));
        TextBundle texts = new TextBundle(ResourceBundle.getBundle("simgsm.phone.messages", locale), Locale.ROOT);
        assertEquals(
                words.toLowerCase(Locale.ROOT),
                CauseText.ofRefusal(
                                texts,
                                RejectCause.ofCode(code, simgsm.air.Direction.DOWNLINK),
                                cardRefused,
                                new Msisdn("5550100"))
                        .toLowerCase(Locale.ROOT));
    }
}
