package simgsm.phone.handset;

import java.util.Optional;
import simgsm.dtmf.DtmfKey;

/** The meaning of a robot's reply tones: the paper's six, and 7 and 8. */
public final class ToneMeaning {
    private ToneMeaning() {}

    /** The text key of the meaning; empty for other tones. */
    public static Optional<String> textKey(DtmfKey key) {
        char symbol = key.symbol();
        return symbol >= '1' && symbol <= '8' ? Optional.of("tone." + symbol) : Optional.empty();
    }
}
