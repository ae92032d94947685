package simgsm.phone.handset;

import java.util.Optional;
import simgsm.dtmf.DtmfKey;

/** Which tones from the robot mean something: the paper's six, and 7 and 8. */
public final class ToneMeaning {
    private ToneMeaning() {}

    /** The key of the meaning's words in the phone's bundle; empty for a tone that means nothing. */
    public static Optional<String> textKey(DtmfKey key) {
        char symbol = key.symbol();
        return symbol >= '1' && symbol <= '8' ? Optional.of("tone." + symbol) : Optional.empty();
    }
}
