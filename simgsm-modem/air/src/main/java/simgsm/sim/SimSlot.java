package simgsm.sim;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.file.FileErrors;

/** The SIMs of {@code --sim FILE} for the terminals of a program. */
public final class SimSlot {
    private static final System.Logger LOG = System.getLogger(SimSlot.class.getName());

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
    public Optional<InsertedCard> card(Optional<Msisdn> number) {
        if (isEmpty()) {
            return Optional.empty();
        }
        Optional<SimCard> found = number.isPresent() ? file.cardOf(number.get()) : file.onlyCard();
        if (found.isEmpty()) {
            throw new IllegalArgumentException("--sim: " + path.get() + " holds " + holdings() + ", "
                    + number.map(wanted -> "not that of " + wanted).orElse("choose one with --number"));
        }
        if (found.get().pin().isPresent() && !Files.isWritable(path.get())) {
            throw new IllegalArgumentException(
                    "--sim: " + path.get() + " is write-protected, but keeps the tries of the PIN");
        }
        return found.map(card -> new InsertedCard(card, lock(card)));
    }

    /** The lock of a card; its changes are kept in the file. */
    private PinLock lock(SimCard card) {
        return new PinLock(card.pin(), pin -> {
            try {
                SimFile.keep(path.orElseThrow(), card.number(), pin);
            } catch (IOException e) {
                LOG.log(Level.ERROR, "--sim: tries and changes of the PIN are not kept: {0}", FileErrors.describe(e));
            }
        });
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
