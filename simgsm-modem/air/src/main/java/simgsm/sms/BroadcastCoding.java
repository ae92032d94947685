package simgsm.sms;

import java.util.List;
import java.util.Optional;
import simgsm.octets.Bounds;

/**
 * The data coding scheme of cell broadcast, which may also state the language (TS 23.038, 5).
 *
 * @param octet 0 to 255
 */
public record BroadcastCoding(int octet) {
    /** GSM 7-bit, language unspecified. */
    public static final BroadcastCoding GSM_7BIT = new BroadcastCoding(0x0f);
    /** UCS-2, no class, language unspecified. */
    public static final BroadcastCoding UCS2 = new BroadcastCoding(0x48);
    /** UCS-2 after a language of two letters. */
    public static final BroadcastCoding UCS2_WITH_LANGUAGE = new BroadcastCoding(0x11);
    /** GSM 7-bit after a language of two letters and a carriage return. */
    public static final BroadcastCoding GSM_7BIT_WITH_LANGUAGE = new BroadcastCoding(0x10);

    private static final int FURTHER_LANGUAGES = 0x20;
    /** ISO 639 codes by the octet, 0 to 14; 15 is "unspecified". */
    private static final List<String> LANGUAGES =
            List.of("de", "en", "it", "fr", "es", "nl", "sv", "da", "pt", "fi", "no", "el", "tr", "hu", "pl");

    private static final List<String> MORE_LANGUAGES = List.of("cs", "he", "ar", "ru", "is");

    public BroadcastCoding {
        Bounds.checkOctet("broadcast coding", octet);
    }

    /** @param language two letters of ISO 639, or empty */
    public static BroadcastCoding of(Alphabet alphabet, Optional<String> language) {
        if (alphabet == Alphabet.UCS2) {
            return language.isPresent() ? UCS2_WITH_LANGUAGE : UCS2;
        }
        if (language.isEmpty()) {
            return GSM_7BIT;
        }
        int index = LANGUAGES.indexOf(language.get());
        int further = MORE_LANGUAGES.indexOf(language.get());
        return index >= 0
                ? new BroadcastCoding(index)
                : further >= 0 ? new BroadcastCoding(FURTHER_LANGUAGES | further) : GSM_7BIT_WITH_LANGUAGE;
    }

    public Alphabet alphabet() {
        if (octet == UCS2_WITH_LANGUAGE.octet) {
            return Alphabet.UCS2;
        }
        boolean general = octet >> 6 == 1 || octet >> 4 == 0x09;
        if (general) {
            int code = octet >> 2 & 0x03;
            return code == 2 ? Alphabet.UCS2 : code == 1 ? Alphabet.OCTETS : Alphabet.GSM_7BIT;
        }
        return octet >> 4 == 0x0f && (octet & 0x04) != 0 ? Alphabet.OCTETS : Alphabet.GSM_7BIT;
    }

    /** True if the text itself begins with the language. */
    boolean languageLeadsText() {
        return octet == GSM_7BIT_WITH_LANGUAGE.octet || octet == UCS2_WITH_LANGUAGE.octet;
    }

    /** The language stated by the octet. */
    public Optional<String> language() {
        if (octet < LANGUAGES.size()) {
            return Optional.of(LANGUAGES.get(octet));
        }
        int further = octet - FURTHER_LANGUAGES;
        return further >= 0 && further < MORE_LANGUAGES.size()
                ? Optional.of(MORE_LANGUAGES.get(further))
                : Optional.empty();
    }
}
