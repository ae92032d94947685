package simgsm.phone.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.ResourceBundle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.ui.Texts;

class CauseTextTest {
    @ParameterizedTest
    @CsvSource({
        "en, 3, 5550100 is in use by another phone",
        "es, 3, otro tel\u00e9fono ya usa el 5550100",
        "en, 2, refused by the network: IMSI unknown in HLR"
    })
    void whyTheNetworkRefusesThePhoneIsSaidInWords(String language, int code, String words) {
        Locale locale = Texts.bundleLocale(Locale.forLanguageTag(language));
        Texts texts = new Texts(ResourceBundle.getBundle("simgsm.phone.messages", locale), Locale.ROOT);
        assertEquals(
                words.toLowerCase(Locale.ROOT),
                CauseText.ofRefusal(texts, RejectCause.ofCode(code), new Msisdn("5550100"))
                        .toLowerCase(Locale.ROOT));
    }
}
