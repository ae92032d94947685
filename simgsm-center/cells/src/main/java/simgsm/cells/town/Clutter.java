package simgsm.cells.town;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The surroundings (clutter in ITU-R P.1812) distinguished by Hata's formulas. */
public enum Clutter {
    /** A large city with high buildings; COST 231 adds 3 dB. */
    METROPOLITAN,
    /** A town of medium size. */
    URBAN,
    SUBURBAN,
    /** Fields without obstacles. */
    OPEN;

    /** The word of town files. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    static Optional<Clutter> of(String word) {
        return Arrays.stream(values())
                .filter(value -> value.word().equals(word))
                .findFirst();
    }
}
