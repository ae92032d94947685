package simgsm.sim;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import simgsm.octets.OctetString;

/** The functions A3 and A8 of a card. */
public enum CardAlgorithm {
    MILENAGE,
    COMP128V1,
    COMP128V2,
    COMP128V3;

    /** The algorithm with this name in a SIM file. */
    static CardAlgorithm named(String name) {
        return Arrays.stream(values())
                .filter(algorithm -> algorithm.word().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("expected algorithm= with one of "
                        + Arrays.stream(values()).map(CardAlgorithm::word).collect(Collectors.joining(", "))
                        + ", found " + name));
    }

    /** The name in a SIM file. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The vector of a challenge. */
    GsmVector vector(SimCard card, OctetString rand) {
        byte[] challenge = rand.requireLength("RAND", Milenage.KEY_LENGTH).toArray();
        byte[] key = card.k().toArray();
        return switch (this) {
            case MILENAGE -> GsmVector.of(card.functions().orElseThrow(), rand);
            case COMP128V1 -> Comp128.first(key, challenge);
            case COMP128V2 -> Comp128.later(key, challenge, true);
            case COMP128V3 -> Comp128.later(key, challenge, false);
        };
    }
}
