package simgsm.sim;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.file.Utf8Text;

/**
 * A file of SIMs: those of a network ({@code --hlr}) or, with some of its lines, those of the terminals of a program
 * ({@code --sim}). UTF-8 text; {@code #} begins a comment; each line is one of
 *
 * <pre>
 *   sim number=5550100 imsi=001010005550100 k=HEX opc=HEX [barred]
 *   sim number=5550100 imsi=001010005550100 k=HEX op=HEX  [barred]
 *   barred-imei 490154203237518
 * </pre>
 *
 * where HEX is 32 hexadecimal digits. Each number and each IMSI may occur once only.
 *
 * @param barredEquipment terminals that may not register
 */
public record SimFile(List<Subscription> subscriptions, Set<Imei> barredEquipment) {
    /** Most SIMs in a file. */
    public static final int MAX_SUBSCRIPTIONS = 100_000;

    /** A file without SIMs. */
    public static final SimFile EMPTY = new SimFile(List.of(), Set.of());

    private static final int SHOWN = 5;

    public SimFile {
        subscriptions = List.copyOf(subscriptions);
        barredEquipment = Set.copyOf(barredEquipment);
    }

    /**
     * Reads a file.
     *
     * @throws IOException naming the file and, for invalid content, the line and the expected form
     */
    public static SimFile read(Path file) throws IOException {
        return new SimFileReader(file.toString())
                .read(Utf8Text.read(file).lines().toList());
    }

    /** The card of a number. */
    public Optional<SimCard> cardOf(Msisdn number) {
        return subscriptions.stream()
                .map(Subscription::card)
                .filter(card -> card.number().equals(number))
                .findFirst();
    }

    /** The card if the file has exactly one. */
    public Optional<SimCard> onlyCard() {
        return subscriptions.size() == 1 ? Optional.of(subscriptions.get(0).card()) : Optional.empty();
    }

    /** The first 5 numbers, for the text of an error. */
    public String numbers() {
        String shown = subscriptions.stream()
                .limit(SHOWN)
                .map(subscription -> subscription.card().number().digits())
                .collect(Collectors.joining(", "));
        return subscriptions.size() > SHOWN ? shown + " ..." : shown;
    }
}
