package simgsm.air;

import java.util.Optional;

/** The algorithms that cipher the air interface (TS 43.020, 4.9), in the order of their codes; A5/2 is broken and forbidden. */
public enum CipherAlgorithm {
    A5_0,
    A5_1,
    A5_2,
    A5_3;

    /** The algorithm of a cipher mode setting (TS 44.018, 10.5.2.9). @throws ProtocolViolation for A5/4 to A5/7 */
    static CipherAlgorithm ofSetting(int setting) throws ProtocolViolation {
        int number = (setting & 1) == 0 ? 0 : (setting >> 1 & 0x07) + 1;
        return ofRsl(number + 1)
                .orElseThrow(() -> ProtocolViolation.invalid("cipher algorithm A5/" + number + " is not known here"));
    }

    /** The algorithm of an identifier in RSL (TS 48.058, 9.3.7). */
    public static Optional<CipherAlgorithm> ofRsl(int identifier) {
        return identifier > 0 && identifier <= values().length
                ? Optional.of(values()[identifier - 1])
                : Optional.empty();
    }

    int setting() {
        return this == A5_0 ? 0 : ordinal() - 1 << 1 | 1;
    }

    public int rsl() {
        return ordinal() + 1;
    }

    /** As "a5/1". */
    public String title() {
        return "a5/" + ordinal();
    }
}
