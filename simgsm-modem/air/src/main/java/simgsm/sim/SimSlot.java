package simgsm.sim;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import simgsm.air.Msisdn;

/** The SIMs of {@code --sim FILE} for the terminals of a program. */
public final class SimSlot {
    private final Optional<Path> path;
    private final SimFile file;

    private SimSlot(Optional<Path> path, SimFile file) {
        this.path = path;
        this.file = file;
    }

    /**
     * Reads the file, if given.
     *
     * @throws IOException naming the file that cannot be read
     */
    public static SimSlot of(Optional<Path> path) throws IOException {
        return new SimSlot(path, path.isPresent() ? SimFile.read(path.get()) : SimFile.EMPTY);
    }

    /** True if no file was given: the terminals then use an open network. */
    public boolean isEmpty() {
        return path.isEmpty();
    }

    /**
     * The card for a terminal; empty without a file.
     *
     * @param number of the card; without it the file must hold exactly one
     * @throws IllegalArgumentException if the file has no such card, or several and no number is given
     */
    public Optional<SimCard> card(Optional<Msisdn> number) {
        if (isEmpty()) {
            return Optional.empty();
        }
        Optional<SimCard> found = number.isPresent() ? file.cardOf(number.get()) : file.onlyCard();
        if (found.isEmpty()) {
            throw new IllegalArgumentException("--sim: " + path.get() + " holds " + holdings() + ", "
                    + number.map(wanted -> "not that of " + wanted).orElse("choose one with --number"));
        }
        return found;
    }

    private String holdings() {
        int count = file.subscriptions().size();
        return switch (count) {
            case 0 -> "no SIM";
            case 1 -> "the SIM of " + file.numbers();
            default -> count + " SIMs (" + file.numbers() + ")";
        };
    }
}
